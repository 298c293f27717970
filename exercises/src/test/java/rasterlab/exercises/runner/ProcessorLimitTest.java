package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.exercises.Sources;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.TimeLimit;

/** Processor time is limited; wall time catches only what waits. */
@Tag("slow")
class ProcessorLimitTest {
    private static final Duration SECOND = Duration.ofSeconds(1);

    @Test
    @DisplayName("a busy machine gets no more patience than an idle one")
    void patienceGrowsWithTheLoad() {
        Duration idle = new Patience(() -> 0).limit(SECOND).wall();
        Duration busy = new Patience(() -> 4).limit(SECOND).wall();
        Duration unknown = new Patience(() -> -1).limit(SECOND).wall();
        assertEquals(Duration.ofSeconds(Patience.MARGIN), idle);
        assertEquals(Duration.ofSeconds(5 * Patience.MARGIN), busy);
        assertEquals(idle, unknown);
        Duration endless = new Patience(() -> 1e9).limit(SECOND).wall();
        assertEquals(Duration.ofSeconds(Patience.MOST), endless);
    }

    @ParameterizedTest(name = "a method that loses its turn is too slow: {0}")
    @EnumSource(JudgeSettings.Protection.class)
    void waitingForTheProcessorIsNoTimeOut(JudgeSettings.Protection box) throws Exception {
        String late = "try { Thread.sleep(1500); } catch (InterruptedException e) { }\n";
        TimeLimit limit = new TimeLimit(Duration.ofMillis(900), Duration.ofMinutes(5));
        try (Unscanned unscanned = new Unscanned(box)) {
            assertEquals(1, unscanned.draw(method(late + "out.plot(1, 1);"), limit));
        }
    }

    @ParameterizedTest(name = "one that sleeps is waited for without end, or called busy: {0}")
    @EnumSource(JudgeSettings.Protection.class)
    void sleepingIsTold(JudgeSettings.Protection box) {
        String forEver = "try { Thread.sleep(600_000); } catch (InterruptedException e) { }\n";
        TimeLimit limit = new TimeLimit(Duration.ofSeconds(4), Duration.ofSeconds(5));
        ChildLost lost = stopped(box, forEver, limit);
        assertTrue(lost.isIdle(), lost::getMessage);
        assertEquals("no answer within 5.0 s, most of which it waited", lost.getMessage());
    }

    @ParameterizedTest(name = "one that computes without end is called idle: {0}")
    @EnumSource(JudgeSettings.Protection.class)
    void computingWithoutEndIsStoppedByProcessorTime(JudgeSettings.Protection box) {
        TimeLimit limit = new TimeLimit(Duration.ofMillis(900), Duration.ofMinutes(30));
        ChildLost lost = stopped(box, "while (true);", limit);
        assertFalse(lost.isIdle(), lost::getMessage);
        assertEquals("no answer within 0.9 s of processor time", lost.getMessage());
    }

    private static ChildLost stopped(JudgeSettings.Protection box, String body, TimeLimit limit) {
        try (Unscanned unscanned = new Unscanned(box)) {
            ChildLost lost =
                    assertThrows(ChildLost.class, () -> unscanned.draw(method(body), limit));
            assertEquals(ChildLost.LossReason.TIME, lost.reason());
            return lost;
        }
    }

    private static String method(String body) {
        return Sources.method(body);
    }
}
