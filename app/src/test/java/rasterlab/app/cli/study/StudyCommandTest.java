package rasterlab.app.cli.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.outcome.ExitCode;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.runner.JudgeSettings;

@Tag("slow")
class StudyCommandTest {
    @TempDir Path folder;

    @Test
    @DisplayName("a program of the user's own has no row, or one that does not compile has one")
    void ownProgramIsOneMoreMethod() throws Exception {
        String body =
                "int n = Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0));\n"
                        + "for (int k = 0; k <= n; k++) out.plot("
                        + "x0 + Math.round((float) k * (x1 - x0) / Math.max(1, n)), "
                        + "y0 + Math.round((float) k * (y1 - y0) / Math.max(1, n)));";
        Ran ran = withSource(body);
        ran.assertDone();
        assertTrue(ran.out().lines().filter(row -> row.startsWith("mine")).count() > 3);
        withSource("out.plot(x0, y0)")
                .assertComplains(
                        ExitCode.BAD_INPUT,
                        "./lab study: your program cannot run because of line 4; 'Check' in its"
                                + " exercise says why");
        Ran.lab("study", "line", "--exercise", "line-bresenham")
                .assertComplains(
                        ExitCode.BAD_INPUT,
                        "./lab study: --exercise and --exercises go with --with SOURCE");
    }

    @Test
    @DisplayName("a program that hangs or throws takes the methods' rows away, or is not told of")
    void ownProgramThatFailsIsToldOf() throws Exception {
        Ran endless = withSource("while (x0 <= x1 || x1 <= x0) y0++;");
        endless.assertDone();
        String limit = JudgeSettings.once().callLimit().toSeconds() + " s";
        assertTrue(
                endless.out().contains("Your program did not answer within " + limit),
                endless.out());
        assertTrue(endless.out().lines().anyMatch(row -> row.startsWith("bresenham ")));
        Ran throwing = withSource("out.plot(x0 / (y0 - y0), 0);");
        throwing.assertDone();
        assertTrue(
                throwing.out()
                        .lines()
                        .anyMatch(
                                row ->
                                        row.equals(
                                                "Your program threw java.lang.ArithmeticException:"
                                                        + " / by zero, in line 4")),
                throwing.out());
    }

    private Ran withSource(String body) throws Exception {
        Path source =
                Files.writeString(
                        folder.resolve("Mine.java"),
                        "import rasterlab.contract.*;\n"
                                + "public class Mine implements LineRasterizer {\n"
                                + "public void draw(int x0, int y0, int x1, int y1, Pixels out) {\n"
                                + body
                                + "\n}\n}\n");
        return Ran.lab(
                "study",
                "line",
                "--quick",
                "--rounds",
                "1",
                "--seconds",
                "0",
                "--with",
                source.toString());
    }

    @Test
    void writesEveryForm() throws Exception {
        String start = folder.resolve("matrix").toString();
        Ran ran =
                Ran.lab(
                        "study",
                        "matrix",
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
                List.of("matrix.PNG", "matrix.csv", "matrix.json", "matrix.svg"),
                names(),
                "nothing else");
        BufferedImage chart = ImageIO.read(folder.resolve("matrix.PNG").toFile());
        assertEquals("1000×700", chart.getWidth() + "×" + chart.getHeight());
        JsonNode json = new ObjectMapper().readTree(folder.resolve("matrix.json").toFile());
        int measurements = json.path("measurements").size();
        assertTrue(measurements > 0);
        assertEquals(measurements + 1, Files.readAllLines(folder.resolve("matrix.csv")).size());
        assertEquals(
                measurements,
                ran.out().lines().filter(row -> row.matches(".* rows-\\d+ .*")).count());
        assertTrue(json.path("machine").hasNonNull("java"));
        assertTrue(json.hasNonNull("seed") && json.hasNonNull("date"), "how it was measured");
        assertTrue(json.path("load").hasNonNull("before"));
        JsonNode first = json.path("measurements").get(0);
        assertTrue(first.path("rounds").size() >= 8, "every round");
        assertEquals(2, first.path("nanosPerItem").path("interval").size());
        assertTrue(Files.readString(folder.resolve("matrix.svg")).contains("<svg"));
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
        var study = new Study("line", "pixel", "pixels", List.of(endless));
        assertEquals(
                List.of("naive-textbook", "w", "–", "–", "–", "–", "endless"),
                List.of(
                        new StudyTable(study, ReportLanguage.EN)
                                .narrow()
                                .get(2)
                                .trim()
                                .split(" +")));
        assertEquals(
                List.of("naive-textbook", "w", "16", "–", "–", "–", "–", "endless"),
                List.of(new StudyTable(study, ReportLanguage.EN).wide().get(1).trim().split(" +")));
        for (List<String> lines :
                List.of(
                        new StudyTable(study, ReportLanguage.RU).narrow(),
                        new StudyTable(study, ReportLanguage.RU).wide()))
            assertTrue(
                    lines.stream().anyMatch(line -> line.endsWith("не останавливается")),
                    "" + lines);
    }

    @ParameterizedTest(name = "fractions of the table in {0} have the other language''s mark")
    @EnumSource
    void fractionsHaveTheMarkOfTheLanguage(ReportLanguage language) {
        var cost = new Cost(2.5, 1.25, 0.001 + 2.5, Map.of("items", 3L));
        var error = new Deviation(1.0 / 3, 1, 0, 20, "pixel");
        var each = new Measurement("dda", "w", 16, cost, error, Verdict.Kind.DEGRADED, "");
        var study = new Study("line", "pixel", "pixels", List.of(each));
        String wrong = language == ReportLanguage.RU ? "\\d\\.\\d" : "\\d,\\d";
        for (List<String> lines :
                List.of(
                        new StudyTable(study, language).narrow(),
                        new StudyTable(study, language).wide())) {
            String row =
                    lines.stream().filter(line -> line.contains("dda")).findAny().orElseThrow();
            assertFalse(Pattern.compile(wrong).matcher(row).find(), row);
            assertTrue(row.contains("2,50") || row.contains("2.50"), row);
        }
    }

    @ParameterizedTest(name = "the table of {0} is wider than a terminal")
    @MethodSource("topics")
    void narrowTableKeepsItsWidth(Topic<?, ?, ?> topic) {
        var cost =
                new Cost(1234567.8, 123456.7, 12345678.9, Map.of("items", 1L, "comparisons", 3L));
        var error = new Deviation(1.0 / 3, 12_345, 0, 20_000, "pixel");
        var measured = new ArrayList<Measurement>();
        for (var method : topic.methods())
            for (var load : topic.workloads())
                measured.add(
                        new Measurement(
                                method.name(),
                                load.name(),
                                load.size(),
                                cost,
                                error,
                                Verdict.Kind.DEGRADED,
                                ""));
        var lines =
                new StudyTable(
                                new Study(topic.name(), topic.item(), topic.errorUnit(), measured),
                                ReportLanguage.EN)
                        .narrow();
        for (String line : lines) assertTrue(line.length() <= StudyTable.WIDTH, line);
        assertEquals("--wide adds what was counted: comparisons", lines.get(lines.size() - 1));
    }

    static Stream<Topic<?, ?, ?>> topics() {
        return Topics.all().stream();
    }

    /**
     * The course's 17 operations with 12 multiplications against 13 with 8, for a single point; one
     * addition more is counted for the matrix, that of ρ, which the course leaves out.
     */
    @Test
    void viewShowsThatTakingItApartSavesOperations() {
        Ran ran = Ran.lab("study", "view", "--quick", "--wide");
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
    void settingsThatCannotBeMeasuredWithAreRefused() {
        Ran.lab("study", "line", "--rounds", "0")
                .assertComplains(2, "./lab study: --rounds must be at least 1, got 0");
        Ran.lab("study", "line", "--rounds", "x")
                .assertComplains(
                        2,
                        "./lab study: invalid value for option '--rounds': 'x' is not a whole"
                                + " number; expected one of at least 1 (see `./lab study --help`)");
        Ran.lab("study", "line", "--seconds", "-1")
                .assertComplains(2, "./lab study: --seconds must be from 0 to 86400, got -1");
        Ran.lab("study", "line", "--chart", "pie")
                .assertComplains(
                        2,
                        "./lab study: no chart 'pie'; there are front, sizes, cost-growth,"
                                + " error-growth, error-by-input");
        Ran.lab("study", "line", "--cost", "money")
                .assertComplains(
                        2,
                        "./lab study: --cost must be one of time, operations, parts, got 'money'");
        Ran.lab("study", "line", "--cost", "parts")
                .assertComplains(
                        2,
                        "./lab study: no method chooses of how many parts an answer is made in"
                                + " topic 'line'");
        Ran.lab("study", "matrix", "--cost", "operations")
                .assertComplains(2, "./lab study: nothing is counted in topic 'matrix'");
        Ran.lab("study", "--ship", "anywhere")
                .assertComplains(2, "./lab study: --ship DIR needs TOPIC or --all");
    }

    @Test
    @DisplayName("pages of findings name a command with other settings than their own")
    void pagesRepeatAllSettings() {
        assertEquals("", StudyCommand.pace(false, Optional.empty(), Optional.empty()));
        assertEquals(
                " --quick --rounds 5 --seconds 0.5",
                StudyCommand.pace(true, Optional.of(5), Optional.of(0.5)));
        assertEquals(
                " --seconds 100", StudyCommand.pace(false, Optional.empty(), Optional.of(100.0)));
    }

    @Test
    void unknownLanguageIsToldThoseThereAre() {
        Ran.lab("study", "line", "--lang", "fr")
                .assertComplains(
                        2,
                        "./lab study: invalid value for option '--lang': expected one of en, ru,"
                                + " got 'fr' (see `./lab study --help`)");
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
