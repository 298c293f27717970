package rasterlab.app.cli.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.study.CountedStudy;
import rasterlab.app.study.StudyCost;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.measuring.Machine;

class RankingTextTest {
    private static final List<Double> CALM = times(1, 0.001);
    private static final List<Double> BUSY = times(1, 0.3);

    /** Twelve times that rise evenly, by that share from the first to the last. */
    private static List<Double> times(double nanos, double spread) {
        var times = new ArrayList<Double>();
        for (int i = 0; i < 12; i++) times.add(nanos * (1 + spread * i / 11));
        return times;
    }

    private static Measurement timed(String method, List<Double> rounds, long additions) {
        return new Measurement(
                method,
                "w",
                16,
                Cost.of(rounds, Map.of("items", 2L, "additions", additions)),
                Deviation.NONE,
                Verdict.Kind.EXACT,
                "");
    }

    private static Study study(List<Double> fixed, boolean whole) {
        return new Study(
                "line",
                "pixel",
                "pixels",
                List.of(
                        timed("naive", times(30, 0.01), 12),
                        timed("dda", times(10, 0.01), 8),
                        timed("wu", times(10.2, 0.01), 8)),
                Optional.of(
                        new StudyConditions(
                                StudySettings.quick(),
                                Instant.EPOCH,
                                Machine.here(),
                                0.5,
                                -1,
                                Map.of("w", fixed),
                                whole)));
    }

    private static String text(Study study, ReportLanguage language) {
        return String.join("\n", new RankingText(study, language).lines());
    }

    @Test
    void whatIsToldApartStandsInOrderAndWhatIsAlikeIsSaidToBe() {
        String said = text(study(CALM, true), ReportLanguage.EN);
        assertTrue(said.contains("\nw: dda ~ wu < naive\n"), said);
        assertTrue(said.contains("up to 0.0 %"), said);
        assertTrue(said.contains("load of the machine 0.5\nbefore, – after"), said);
    }

    @Test
    void aBusyMachineTellsNothingApartAndSaysWhatWouldSettleIt() {
        String said = text(study(times(1, 4), true), ReportLanguage.EN);
        assertTrue(said.contains("\nw: dda ? wu ? naive\n"), said);
        assertTrue(said.contains("Noise: not measurable now, a fixed"), said);
        assertFalse(said.contains("off by up to"), said);
        String russian = text(study(times(1, 4), true), ReportLanguage.RU);
        assertTrue(russian.contains("Шум: сейчас не измерить"), russian);
        String less = text(study(BUSY, true), ReportLanguage.EN);
        assertTrue(less.contains("more rounds (--rounds "), less);
        assertTrue(text(study(BUSY, true), ReportLanguage.RU).contains("Ещё примерно"), less);
    }

    @Test
    void aStudyThatWasStoppedSaysSo() {
        assertTrue(text(study(CALM, false), ReportLanguage.EN).contains("Stopped before its end"));
    }

    @Test
    @DisplayName("an order of a few rounds is told as one of many")
    void fewRoundsAreSaidToTellLess() {
        Study study = study(CALM, true);
        assertFalse(text(study, ReportLanguage.EN).contains("Fewer than"));
        var few = new ArrayList<Measurement>();
        for (Measurement one : study.measurements())
            few.add(timed(one.method(), one.cost().rounds().subList(0, 7), 1));
        assertTrue(text(study.with(few), ReportLanguage.EN).contains("Fewer than 8 rounds"));
        assertTrue(text(study.with(few), ReportLanguage.RU).contains("Прогонов меньше 8"));
    }

    @Test
    @DisplayName("a study that timed nothing before it was stopped says nothing of it")
    void studyWithoutARoundSaysWhy() {
        Study study = study(CALM, false);
        var untimed = new ArrayList<Measurement>();
        for (Measurement one : study.measurements()) untimed.add(timed(one.method(), List.of(), 1));
        String said = text(study.with(untimed), ReportLanguage.EN);
        assertTrue(said.startsWith("Stopped before the first round"), said);
        assertEquals("", text(study(CALM, true).with(untimed), ReportLanguage.EN));
    }

    @Test
    void countedOperationsAreInOrderWithoutNoise() {
        Study counted = CountedStudy.of(study(BUSY, true));
        List<String> lines =
                new RankingText(counted, StudyCost.OPERATIONS, ReportLanguage.EN).lines();
        assertEquals("w: dda 4.000 = wu 4.000 < naive 6.000", lines.get(lines.size() - 1));
    }
}
