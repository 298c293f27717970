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
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.study.HazardMatrix;
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
        var settings =
                new StudySettings(
                        Duration.ZERO, Duration.ofNanos(1), 8, StudySettings.quick().wallLimit());
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
        assertTrue(page("index.html").contains("не измерено"));
        assertFalse(Files.exists(folder.resolve("matrix.html")));
    }

    private static Measurement timed(String method, double nanos, double error) {
        var rounds = new ArrayList<Double>();
        for (int i = 0; i < 12; i++) rounds.add(nanos * (1 + 0.001 * i));
        return new Measurement(
                method,
                "points-16",
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
        assertTrue(open.contains("it is not told what exactness costs"), open);
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
