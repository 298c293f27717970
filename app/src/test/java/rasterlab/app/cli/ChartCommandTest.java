package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.MethodColours;

class ChartCommandTest {
    @TempDir Path folder;

    @Test
    void tableShowsWhereGammaRunsAway() {
        Ran ran = Ran.lab("chart", "perspective");
        List<String> rows =
                ran.out().lines().map(row -> row.strip().replaceAll(" +", " ")).toList();
        assertEquals("z'/dz' gamma stretch", rows.get(0));
        for (String row :
                List.of(
                        "1.0 3.000 runs-away",
                        "2.0 2.000 edge",
                        "3.0 1.667 calm",
                        "4.0 1.500 calm")) assertTrue(rows.contains(row), row + " in " + rows);
        ran.assertDone();
    }

    @Test
    void writesEveryForm() throws Exception {
        Path png = folder.resolve("g.PNG");
        Path csv = folder.resolve("g.csv");
        Ran.lab("chart", "perspective", "--out", png.toString(), "--out", csv.toString())
                .assertDone();
        BufferedImage picture = ImageIO.read(png.toFile());
        assertEquals("1000×700", picture.getWidth() + "×" + picture.getHeight());
        assertTrue(has(picture, MethodColours.BLUE), "the curve's colour");
        List<String> lines = Files.readAllLines(csv);
        assertEquals("distance,gamma,stretch", lines.get(0));
        assertEquals("0.25,9.0,runs-away", lines.get(1));
        assertTrue(lines.contains("4.0,1.5,calm"), lines.toString());
    }

    private static boolean has(BufferedImage picture, Color colour) {
        for (int y = 0; y < picture.getHeight(); y++)
            for (int x = 0; x < picture.getWidth(); x++)
                if (picture.getRGB(x, y) == colour.getRGB()) return true;
        return false;
    }

    @Test
    void russianChartHasNoEnglishWords() throws Exception {
        Path svg = folder.resolve("g.svg");
        Ran.lab("chart", "perspective", "--lang", "ru", "--out", svg.toString()).assertDone();
        String text = Files.readString(svg);
        assertTrue(text.contains("как в параллельной проекции"), "its limit");
        assertEquals(
                List.of(),
                Pattern.compile(">([^<]*[a-zA-Z]{3}[^<]*)<")
                        .matcher(text)
                        .results()
                        .map(found -> found.group(1).strip())
                        .toList());
    }

    @Test
    void mistakesAreFoundBeforeAnythingIsWritten() {
        Ran.lab("chart", "perspektive")
                .assertComplains(
                        2,
                        "./lab chart: no chart 'perspektive';"
                                + " there are perspective, visibility-growth");
        Path strange = folder.resolve("g.json");
        Ran.lab("chart", "perspective", "--out", strange.toString())
                .assertComplains(
                        2,
                        "./lab chart: "
                                + strange
                                + ": unknown extension; allowed are .svg, .png, .csv");
    }
}
