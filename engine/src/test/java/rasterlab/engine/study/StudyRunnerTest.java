package rasterlab.engine.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Verdict.Kind;

class StudyRunnerTest {
    private static final StudySettings SHORT =
            new StudySettings(Duration.ZERO, Duration.ofNanos(1), 3, Duration.ofMinutes(2));

    @Test
    void aMethodThatFailsGetsItsRowAndTheStudyGoesOn() {
        Study study =
                measure(
                        List.of(
                                LinesOf.method("endless", HazardTrialTest.forever()),
                                LinesOf.method(
                                        "crashing",
                                        HazardTrialTest.throwing(new ArithmeticException())),
                                LinesOf.method(
                                        "refusing",
                                        HazardTrialTest.throwing(
                                                new IllegalArgumentException("no"))),
                                LinesOf.method("nothing", HazardTrialTest.nothing()),
                                LinesOf.method("right", HazardTrialTest.right())));
        assertEquals(10, study.measurements().size());
        assertEquals(
                List.of(Kind.ENDLESS, Kind.CRASHED, Kind.REFUSED, Kind.WRONG, Kind.EXACT),
                study.measurements().stream().limit(5).map(Measurement::kind).toList());
        for (Measurement failed : study.measurements().subList(0, 3))
            assertEquals(Cost.NONE, failed.cost());
        assertEquals("no", study.measurements().get(2).detail());
    }

    @Test
    void countsPixelsAndInputsAndSumsErrors() {
        Study study =
                measure(
                        List.of(
                                LinesOf.method("right", HazardTrialTest.right()),
                                LinesOf.method("nothing", HazardTrialTest.nothing())));
        Measurement right = study.measurements().get(0);
        assertEquals("short", right.workload());
        assertEquals(4, right.size());
        assertEquals(Map.of("ends", 4L, "inputs", 2L, "items", 8L), right.cost().counts());
        assertTrue(right.cost().timed());
        assertEquals(new Deviation(0, 0, 0, 8, ""), right.error());
        Measurement nothing = study.measurements().get(1);
        assertFalse(nothing.cost().timed());
        assertEquals(new Deviation(4, 8, 0, 8, "pixel (0, 0) is missing"), nothing.error());
    }

    @Test
    void aMethodThatFailsOnlyWhileItIsTimedGetsItsVerdictToo() {
        var calls = new AtomicInteger();
        LineRasterizer later =
                (x0, y0, x1, y1, out) -> {
                    if (calls.incrementAndGet() > 3) throw new IllegalStateException("worn out");
                    HazardTrialTest.right().draw(x0, y0, x1, y1, out);
                };
        Measurement last = measure(List.of(LinesOf.method("later", later))).measurements().get(1);
        assertEquals(Kind.CRASHED, last.kind());
        assertEquals(Cost.NONE, last.cost());
        assertTrue(last.detail().contains("worn out"), last.detail());
    }

    @Test
    void progressRisesToItsTotal() {
        var heard = new ArrayList<Progress>();
        var topic = new LinesOf(List.of(LinesOf.method("right", HazardTrialTest.right())));
        StudyRunner.measure(topic, SHORT, heard::add, () -> false);
        assertEquals(10, heard.size());
        for (int i = 0; i < heard.size(); i++) assertEquals(i + 1, heard.get(i).done());
        assertEquals(10, heard.get(0).total());
    }

    @Test
    void whatWasMeasuredBeforeItIsCancelledIsKept() {
        var heard = new ArrayList<Progress>();
        var topic = new LinesOf(List.of(LinesOf.method("right", HazardTrialTest.right())));
        Study judged = StudyRunner.measure(topic, SHORT, heard::add, () -> heard.size() == 1);
        assertEquals(1, heard.size());
        assertEquals(
                List.of("short"),
                judged.measurements().stream().map(Measurement::workload).toList());
        assertFalse(judged.measurements().get(0).cost().timed());
        heard.clear();
        Study timed = StudyRunner.measure(topic, SHORT, heard::add, () -> heard.size() == 5);
        assertEquals(1, timed.measurements().get(0).cost().rounds().size());
        assertFalse(timed.isWhole());
    }

    @Test
    void tellsHowItWasMeasured() {
        Study study = measure(List.of(LinesOf.method("right", HazardTrialTest.right())));
        StudyConditions how = study.circumstances().orElseThrow();
        assertTrue(how.whole());
        assertEquals(SHORT, how.settings());
        assertEquals(3, how.fixed().get("short").size(), "the fixed load has each round too");
        assertEquals(3, study.measurements().get(0).cost().rounds().size());
        assertTrue(study.noise("short") >= 1);
    }

    @Test
    void unknownTopicNamesTheKnownOnes() {
        var refusal = assertThrows(IllegalArgumentException.class, () -> Topics.named("spiral"));
        assertTrue(
                refusal.getMessage().startsWith("no topic 'spiral'; there are line"),
                refusal.getMessage());
        assertEquals("line", Topics.named("line").name());
    }

    @Test
    void settingsRefuseWhatCannotBeMeasured() {
        Duration ms = Duration.ofMillis(1);
        var zero = Duration.ZERO;
        assertThrows(IllegalArgumentException.class, () -> new StudySettings(ms, zero, 1, ms));
        assertThrows(IllegalArgumentException.class, () -> new StudySettings(ms, ms, 0, ms));
        assertThrows(IllegalArgumentException.class, () -> new StudySettings(ms, ms, 1, zero));
        assertThrows(
                IllegalArgumentException.class, () -> new StudySettings(ms.negated(), ms, 1, ms));
    }

    private static Study measure(List<Method<LineRasterizer>> methods) {
        return StudyRunner.measure(new LinesOf(methods), SHORT, p -> {}, () -> false);
    }
}
