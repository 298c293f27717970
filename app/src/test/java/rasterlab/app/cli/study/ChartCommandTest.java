package rasterlab.app.cli.study;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.cli.Ran;
import rasterlab.app.rooms.LabRooms;

class ChartCommandTest {
    @TempDir Path folder;

    @Test
    void lineBrightnessIsDrawnByTheMethodsThatAreNamed() throws Exception {
        Path csv = folder.resolve("light.csv");
        Ran ran =
                Ran.lab("chart", "line-brightness", "--methods", "wu,dda", "--out", csv.toString());
        ran.assertDone();
        List<String> rows = Files.readAllLines(csv);
        assertEquals("degrees,wu,dda", rows.get(0));
        assertEquals(92, rows.size());
        double diagonal = Double.parseDouble(rows.get(46).split(",")[2]);
        assertEquals(Math.sqrt(0.5), diagonal, 0.01, "a diagonal has fewer pixels than length");
        Ran unknown = Ran.lab("chart", "line-brightness", "--methods", "wuu");
        assertEquals(2, unknown.exitCode());
        assertTrue(unknown.err().contains("'wuu'; there are naive"), unknown.err());
        Ran.lab("chart", "mach-bands", "--methods", "wu")
                .assertComplains(2, "./lab chart: --methods is for chart line-brightness");
    }

    @ParameterizedTest(name = "an empty name is passed over: \"{0}\"")
    @ValueSource(strings = {"wu,", ",wu", "wu,,dda", ",", ""})
    void emptyNameIsRefused(String methods) {
        Ran ran = Ran.lab("chart", "line-brightness", "--methods", methods);
        String start =
                "./lab chart: --methods '" + methods + "' has an empty name; expected some of";
        assertTrue(ran.err().startsWith(start), ran.err());
        assertTrue(ran.err().contains(" wu with commas between them"), ran.err());
        assertEquals(2, ran.exitCode());
        assertEquals("", ran.out());
    }

    @ParameterizedTest(name = "heads of the table stay English: {0}")
    @ValueSource(
            strings = {
                "perspective",
                "depth-precision",
                "mach-bands",
                "line-brightness",
                "sign-map"
            })
    void headsAreRussian(String chart) {
        String english = Ran.lab("chart", chart).out().lines().findFirst().orElseThrow();
        String russian =
                Ran.lab("chart", chart, "--lang", "ru").out().lines().findFirst().orElseThrow();
        for (String head : english.strip().split(" {2,}"))
            if (head.matches("[a-z ]{5,}") && !head.equals("gamma"))
                assertFalse(russian.contains(head), russian);
        assertTrue(Pattern.compile("[а-я]{5}").matcher(russian).find(), russian);
    }

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
        String russian = Ran.lab("chart", "perspective", "--lang", "ru").out();
        assertTrue(russian.contains("  2,000  на границе\n"), russian);
    }

    @ParameterizedTest(name = "people read decimal points in Russian, or programs commas: {0}")
    @ValueSource(strings = {"perspective", "depth-precision", "mach-bands", "line-brightness"})
    void fractionsHaveTheMarkOfWhoReadsThem(String chart) throws Exception {
        Path csv = folder.resolve("c.csv");
        Ran ran = Ran.lab("chart", chart, "--lang", "ru", "--out=" + csv);
        ran.assertDone();
        assertFalse(Pattern.compile("\\d\\.\\d").matcher(ran.out()).find(), ran.out());
        assertTrue(Pattern.compile("\\d,\\d").matcher(ran.out()).find(), ran.out());
        assertTrue(Files.readString(csv).contains("0."), "in the file of values");
    }

    @Test
    void writesEveryForm() throws Exception {
        Path png = folder.resolve("g.PNG");
        Path csv = folder.resolve("g.csv");
        Ran ran = Ran.lab("chart", "perspective", "--out", png.toString(), "--out", csv.toString());
        ran.assertDone();
        assertEquals("wrote " + png + "\nwrote " + csv + "\n", ran.err());
        BufferedImage picture = ImageIO.read(png.toFile());
        assertEquals("1000×700", picture.getWidth() + "×" + picture.getHeight());
        assertFalse(has(picture, MethodColors.BLUE, 500, 0), "the curve does not fall");
        assertTrue(has(picture, MethodColors.BLUE, 500, 350), "the curve does not end low");
        List<String> lines = Files.readAllLines(csv);
        assertEquals("distance,gamma,stretch", lines.get(0));
        assertEquals("0.25,9.0,runs-away", lines.get(1));
        assertTrue(lines.contains("4.0,1.5,calm"), lines.toString());
    }

    @Test
    void machBandsAreStepsThenBendsThenNeither() throws Exception {
        Path csv = folder.resolve("m.csv");
        Ran ran = Ran.lab("chart", "mach-bands", "--out=" + csv);
        ran.assertDone();
        assertTrue(ran.out().contains("gouraud"), ran.out());
        List<String> lines = Files.readAllLines(csv);
        assertEquals("faces,flat,gouraud,phong", lines.get(0));
        assertEquals(1 + 8 * 51, lines.size());
    }

    @Test
    void depthPrecisionIsMeasuredBesideItsFormula() throws Exception {
        Path png = folder.resolve("d.png");
        Path csv = folder.resolve("d.csv");
        Ran ran =
                Ran.lab(
                        "chart",
                        "depth-precision",
                        "--out",
                        png.toString(),
                        "--out",
                        csv.toString());
        ran.assertDone();
        List<String> rows =
                ran.out().lines().map(row -> row.strip().replaceAll(" +", " ")).toList();
        assertEquals("format far/near measured predicted", rows.get(0));
        for (String row :
                List.of(
                        "z16 1e+03 7.576e-03 7.576e-03",
                        "z16 1e+06 1.768e+00 1.768e+00",
                        "z24 1e+03 2.977e-05 2.977e-05",
                        "reversed-z 1e+06 5.684e-08 5.684e-08"))
            assertTrue(rows.contains(row), row + " in " + rows);
        List<String> lines = Files.readAllLines(csv);
        assertEquals("format,far/near,measured,predicted", lines.get(0));
        assertEquals(1 + 6 * 17, lines.size());
        BufferedImage picture = ImageIO.read(png.toFile());
        assertEquals("1000×700", picture.getWidth() + "×" + picture.getHeight());
        assertTrue(
                has(picture, LabRooms.card("depth-buffer").colors().of("zfloat"), 0, 350)
                        || has(
                                picture,
                                LabRooms.card("depth-buffer").colors().of("zfloat"),
                                500,
                                0),
                "the colour of zfloat");
    }

    @Test
    void signMapCountsItsWrongPointsAndTellsThemToPrograms() throws Exception {
        Path json = folder.resolve("s.json");
        Path svg = folder.resolve("s.svg");
        Ran ran =
                Ran.lab(
                        "chart",
                        "sign-map",
                        "orientation/from-p",
                        "point-in-triangle/robust",
                        "--out=" + json,
                        "--out=" + svg);
        ran.assertDone();
        List<String> rows =
                ran.out().lines().map(row -> row.strip().replaceAll(" +", " ")).toList();
        assertEquals("orientation from-p double 32.6 % 2673 2673 0", rows.get(1));
        assertEquals("point-in-triangle robust double 0.0 % 0 0 0", rows.get(2));
        assertTrue(Files.readString(json).contains("\"wrong\" : 5346"), "counted for programs");
        String drawn = Files.readString(svg);
        assertTrue(drawn.contains("orientation from-p"), "its name in the drawing");
        assertTrue(drawn.contains("p = (0.5, 0.5), q = (12, 12), r = (24, 24)"), "all its points");
        assertTrue(drawn.contains("[0.5, 0.5]") || drawn.contains("[[0.5, 0.5]]"), drawn);
    }

    @Test
    void signMapOfAnUnknownPredicateIsRefused() {
        Ran.lab("chart", "sign-map", "orient")
                .assertComplains(
                        2,
                        "./lab chart: no predicate 'orient'; there are orientation, side-of-plane,"
                                + " point-in-triangle, point-in-polygon, clip-segment, clip-volume,"
                                + " visible-faces");
        Ran.lab("chart", "perspective", "orientation")
                .assertComplains(2, "./lab chart: TOPIC/METHOD is for chart sign-map");
    }

    /** Whether a quarter of the picture, with that corner at its top left, has the colour. */
    private static boolean has(BufferedImage picture, Color color, int left, int top) {
        for (int y = top; y < top + 350; y++)
            for (int x = left; x < left + 500; x++)
                if (picture.getRGB(x, y) == color.getRGB()) return true;
        return false;
    }

    @Test
    void russianDepthPrecisionHasNoEnglishWords() throws Exception {
        Path svg = folder.resolve("d.svg");
        Ran.lab("chart", "depth-precision", "--lang", "ru", "--out", svg.toString()).assertDone();
        assertTrue(Files.readString(svg).contains("измерено делением пополам"), "its marks");
        var methods = Set.of("zfloat", "linear-16", "reversed-z");
        assertEquals(
                List.of(),
                Pattern.compile(">([^<]*[a-zA-Z]{3}[^<]*)<")
                        .matcher(Files.readString(svg))
                        .results()
                        .map(found -> found.group(1).strip())
                        .filter(text -> !methods.contains(text))
                        .toList());
    }

    @Test
    void russianChartHasNoEnglishWords() throws Exception {
        Path svg = folder.resolve("g.svg");
        Ran.lab("chart", "perspective", "--lang", "ru", "--out", svg.toString()).assertDone();
        String text = Files.readString(svg);
        assertTrue(text.contains("как в параллельной проекции"), "its limit");
        assertEquals(2, text.split("fill-opacity:0\\.").length - 1, "bands");
        assertEquals(
                List.of(),
                Pattern.compile(">([^<]*[a-zA-Z]{3}[^<]*)<")
                        .matcher(text)
                        .results()
                        .map(found -> found.group(1).strip())
                        .toList());
    }

    @Test
    void pictureIsInItsLanguageToo() throws Exception {
        byte[] english = pngIn("en");
        assertArrayEquals(english, pngIn("EN"));
        assertFalse(Arrays.equals(english, pngIn("ru")), "the Russian picture is the English one");
    }

    private byte[] pngIn(String language) throws Exception {
        Path png = folder.resolve(language + ".png");
        Ran.lab("chart", "perspective", "--lang", language, "--out", png.toString()).assertDone();
        return Files.readAllBytes(png);
    }

    @Test
    @DisplayName("a name with a line break is told in two lines")
    @DisabledOnOs(OS.WINDOWS)
    void aNameIsToldInOneLine() {
        Path file = folder.resolve("a\nb.csv");
        Ran ran = Ran.lab("chart", "perspective", "--out", file.toString());
        assertEquals("wrote " + folder.resolve("a b.csv") + "\n", ran.err());
    }

    @Test
    void mistakesAreFoundBeforeAnythingIsWritten() {
        Ran.lab("chart", "perspektive")
                .assertComplains(
                        2,
                        "./lab chart: no chart 'perspektive'; there are perspective, depth-precision,"
                                + " mach-bands, line-brightness, visibility-growth, curve-segments,"
                                + " sign-map;"
                                + " did you mean 'perspective'?");
        Path strange = folder.resolve("g.json");
        Ran.lab("chart", "perspective", "--out", strange.toString())
                .assertComplains(
                        2,
                        "./lab chart: "
                                + strange
                                + ": unknown extension; allowed are .svg, .png, .csv");
        Path nowhere = folder.resolve("no/g.svg");
        Ran.lab("chart", "perspective", "--out", nowhere.toString())
                .assertComplains(
                        2,
                        "./lab chart: "
                                + nowhere
                                + ": cannot be written: no folder "
                                + nowhere.getParent());
    }
}
