package rasterlab.app.findings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.study.HazardMatrix;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.transform.matrix.MatrixTopic;
import rasterlab.engine.transform.view.ViewTopic;

@Tag("slow")
class FindingsTest {
    @TempDir Path folder;

    private final List<String> said = new ArrayList<>();

    private Findings findings(boolean stopped, Language language) {
        return findings(8, stopped, language);
    }

    private Findings findings(int rounds, boolean stopped, Language language) {
        var settings =
                new StudySettings(
                        Duration.ZERO,
                        Duration.ofNanos(1),
                        rounds,
                        StudySettings.quick().wallLimit());
        return new Findings(folder, settings, " --quick", language, said::add, () -> stopped);
    }

    private String page(String name) throws Exception {
        return Files.readString(folder.resolve(name));
    }

    @Test
    void everyTopicGetsItsPageWithChartsNumbersAndCommands() throws Exception {
        assertTrue(
                findings(false, Language.ENGLISH)
                        .write(List.of(new MatrixTopic(), new ViewTopic())));
        assertEquals(List.of("measuring matrix", "measuring view"), said);
        String view = page("view.html");
        for (String wanted :
                List.of(
                        "./lab study view --quick --seed 1 --chart front --out front.svg",
                        "./lab hazards view",
                        "charts/view-cost-growth-dark.svg",
                        "data/view.json")) assertTrue(view.contains(wanted), wanted);
        for (String link : List.of("charts/view-front.svg", "data/view.json", "data/view.csv"))
            assertTrue(Files.size(folder.resolve(link)) > 0, link);
        assertTrue(page("index.html").contains("<a href=\"matrix.html\">"));
        assertTrue(page("course.html").contains("charts/matrix-front.svg"));
        assertTrue(view.contains("@media print"));
    }

    @Test
    void whatWasNotMeasuredWhenItWasStoppedIsSaid() throws Exception {
        assertFalse(findings(true, Language.RUSSIAN).write(List.of(new MatrixTopic())));
        assertTrue(page("index.html").contains("Не измерено"));
        assertFalse(Files.exists(folder.resolve("matrix.html")));
    }

    @Test
    @DisplayName("a page of a run with other settings or in another language is linked as this one")
    void contentsLinkAnEarlierPageOnlyWithTheSameSettingsAndSayIt() throws Exception {
        List<MatrixTopic> matrix = List.of(new MatrixTopic());
        assertTrue(findings(8, false, Language.ENGLISH).write(matrix));
        assertFalse(page("index.html").contains("earlier run"), "this run wrote it");
        findings(8, true, Language.ENGLISH).write(matrix);
        assertTrue(page("index.html").contains("<a href=\"matrix.html\">"));
        assertTrue(
                page("index.html").contains("of an earlier run with the same settings, begun 20"));
        assertTrue(page("course.html").contains("charts/matrix-front.svg"));
        assertTrue(page("course.html").contains("in an earlier run"));
        findings(9, true, Language.ENGLISH).write(matrix);
        assertFalse(page("index.html").contains("matrix.html"), "other settings");
        assertTrue(page("index.html").contains("it is not linked"));
        assertFalse(page("course.html").contains("matrix-front"));
        findings(8, true, Language.RUSSIAN).write(matrix);
        assertFalse(page("index.html").contains("matrix.html"), "another language");
    }

    @Test
    @DisplayName("a page repeats its charts in another language, or breaks a line behind a number")
    void russianPageRepeatsItselfInRussianAndKeepsNumbersWithWords() throws Exception {
        findings(false, Language.RUSSIAN).write(List.of(new ViewTopic()));
        String view = page("view.html");
        assertTrue(view.contains("./lab --lang ru study view --quick --seed 1 --chart front"));
        assertTrue(view.contains("./lab --lang ru hazards view"));
        assertTrue(view.contains("<h1>Вид по"), "a title begins with a capital");
        assertFalse(Pattern.compile("<p>[^<]*\\d \\p{L}").matcher(view).find());
    }

    private static Measurement timed(String method, double nanos, double error) {
        return timed(method, "points-16", nanos, error);
    }

    private static Measurement timed(String method, String workload, double nanos, double error) {
        var rounds = new ArrayList<Double>();
        for (int i = 0; i < 12; i++) rounds.add(nanos * (1 + 0.001 * i));
        return new Measurement(
                method,
                workload,
                16,
                Cost.of(rounds, Map.of()),
                new Deviation(error, 0, 0, 9, ""),
                error == 0 ? Verdict.Kind.EXACT : Verdict.Kind.DEGRADED,
                "");
    }

    @Test
    void sentencesSayNoMoreThanTheNumbers() {
        var topic = new ViewTopic();
        HazardMatrix hazards = HazardMatrix.judged(topic, HazardTrial.WALL_LIMIT);
        String told = sentences(topic, hazards, 30);
        assertTrue(told.contains("The quickest exact method: taken-apart (16 points)"), told);
        assertTrue(told.contains("exactness costs 3.00 times as much (between 2.9"), told);
        assertTrue(told.contains("It fails first at the workload “16 points”: one-matrix"), told);
        String open = sentences(topic, hazards, 10.3);
        assertTrue(open.startsWith("The quickest exact method: taken-apart (16 points)."), open);
        assertTrue(open.contains("it is not told what exactness costs"), open);
    }

    @Test
    @DisplayName("a winner is named once for each workload, or a sentence ends in two stops")
    void aWinnerIsNamedOnceWithAllItsWorkloads() {
        var topic = new LineTopic();
        HazardMatrix none = new HazardMatrix("line", List.of(), List.of(), List.of());
        var study =
                new Study(
                        "line",
                        "pixel",
                        "pixels",
                        List.of(
                                timed("dda", "length-16", 10, 0),
                                timed("dda", "length-64", 10, 0),
                                timed("dda", "length-256", 10, 0),
                                timed("bresenham", "length-256", 10, 0)));
        assertEquals(
                "Самый быстрый точный метод: dda (отрезки по 16\u00a0пикс.; отрезки по 64\u00a0пикс.)."
                        + " Какой из точных методов самый быстрый, на этой машине в то время не"
                        + " различить на нагрузках: отрезки по 256\u00a0пикс.",
                new FoundWords(topic, study, none, Language.RUSSIAN).sentences().get(0));
    }

    private static String sentences(ViewTopic topic, HazardMatrix hazards, double nanos) {
        var study =
                new Study(
                        "view",
                        "point",
                        "of the largest coordinate",
                        List.of(timed("one-matrix", 10, 0.5), timed("taken-apart", nanos, 0)));
        return String.join(
                "\n", new FoundWords(topic, study, hazards, Language.ENGLISH).sentences());
    }
}
