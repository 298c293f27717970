package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

class StudyCommandTest {
    @TempDir Path folder;

    @Test
    void writesEveryForm() throws Exception {
        String start = folder.resolve("line").toString();
        Ran ran =
                Ran.lab(
                        "study",
                        "line",
                        "--quick",
                        "--out",
                        start + ".svg",
                        "--out",
                        start + ".PNG",
                        "--out",
                        start + ".csv",
                        "--out",
                        start + ".json");
        ran.assertDone();
        assertEquals(
                List.of("line.PNG", "line.csv", "line.json", "line.svg"), names(), "nothing else");
        BufferedImage chart = ImageIO.read(folder.resolve("line.PNG").toFile());
        assertEquals("1000×700", chart.getWidth() + "×" + chart.getHeight());
        JsonNode json = new ObjectMapper().readTree(folder.resolve("line.json").toFile());
        int measurements = json.path("measurements").size();
        assertTrue(measurements > 0);
        assertEquals(measurements + 1, Files.readAllLines(folder.resolve("line.csv")).size());
        assertEquals(measurements + 1, ran.out().lines().count());
        assertTrue(json.path("machine").hasNonNull("java"));
        assertTrue(Files.readString(folder.resolve("line.svg")).contains("<svg"));
    }

    @Test
    void anEndlessMethodIsNotTheFastest() {
        var endless =
                new Measurement(
                        "naive-textbook",
                        "w",
                        16,
                        Cost.NONE,
                        Deviation.NONE,
                        Verdict.Kind.ENDLESS,
                        "");
        String row =
                StudyCommand.table(new Study("line", "pixel", "pixels", List.of(endless)))
                        .lines()
                        .get(1);
        assertEquals(
                List.of("naive-textbook", "w", "16", "–", "–", "–", "–", "endless"),
                List.of(row.trim().split(" +")));
    }

    /**
     * The course's 17 operations with 12 multiplications against 13 with 8, for a single point; one
     * addition more is counted for the matrix, that of ρ, which the course leaves out.
     */
    @Test
    void viewShowsThatTakingItApartSavesOperations() {
        Ran ran = Ran.lab("study", "view", "--quick");
        List<String[]> rows = ran.out().lines().map(row -> row.split("  +")).toList();
        int additions = List.of(rows.get(0)).indexOf("additions/point");
        int products = List.of(rows.get(0)).indexOf("multiplications/point");
        assertTrue(additions > 0 && products > 0, ran.out());
        assertEquals(List.of("12", "6"), counts(rows, "one-matrix", products, additions));
        assertEquals(List.of("8", "5"), counts(rows, "taken-apart", products, additions));
        ran.assertDone();
    }

    private static List<String> counts(List<String[]> rows, String method, int... columns) {
        String[] row =
                rows.stream().filter(cells -> cells[0].equals(method)).findFirst().orElseThrow();
        return IntStream.of(columns).mapToObj(column -> row[column]).toList();
    }

    @Test
    void complainsBeforeItMeasures() {
        Path good = folder.resolve("a.svg");
        Path strange = folder.resolve("a.jpeg");
        Ran.lab("study", "line", "--out", good.toString(), "--out", strange.toString())
                .assertComplains(
                        2,
                        "./lab study: "
                                + strange
                                + ": unknown extension; allowed are .svg, .png, .csv, .json");
        Path nowhere = folder.resolve("no/a.svg");
        Ran.lab("study", "line", "--out", nowhere.toString())
                .assertComplains(
                        2,
                        "./lab study: "
                                + nowhere
                                + ": cannot be written: no folder "
                                + nowhere.getParent());
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void placeThatCannotBeWrittenIsFoundBeforeMeasuring() {
        Ran ran = Ran.lab("study", "line", "--quick", "--out", "/proc/a.svg");
        assertEquals("", ran.out());
        assertEquals(1, ran.err().lines().count(), ran.err());
        assertTrue(ran.err().startsWith("./lab study: /proc/a.svg: cannot be written"), ran.err());
        assertEquals(2, ran.exitCode());
    }

    private List<String> names() throws Exception {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }
}
