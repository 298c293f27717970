package rasterlab.app.mine;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class AwaitingTest {
    private static final Duration LEAST = Duration.ofMillis(100);

    /** The reading of a clock such as a machine's nanoTime, which may be below 0. */
    private long millis = -500;

    private final Awaiting awaiting = new Awaiting(() -> millis * 1_000_000);

    @Test
    void nothingIsAwaitedBeforeTheFirstCall() {
        assertFalse(awaiting.lasts(LEAST));
        assertFalse(awaiting.lasts(Duration.ZERO));
    }

    @Test
    void aCallIsAwaitedOnceItHasLastedLongEnough() {
        awaiting.begin();
        millis += 99;
        assertFalse(awaiting.lasts(LEAST));
        millis += 1;
        assertTrue(awaiting.lasts(LEAST));
    }

    @Test
    void shortCallsInARowAreOneWait() {
        for (int call = 0; call < 20; call++) {
            awaiting.begin();
            millis += 4;
            awaiting.end();
            millis += 1;
        }
        assertTrue(awaiting.lasts(LEAST));
    }

    @Test
    void aPauseEndsIt() {
        awaiting.begin();
        millis += 2000;
        awaiting.end();
        millis += 60;
        assertFalse(awaiting.lasts(LEAST));
        awaiting.begin();
        millis += 50;
        assertFalse(awaiting.lasts(LEAST));
    }

    @Test
    void twoCallsAtOnceAreAwaitedUntilBothHaveEnded() {
        awaiting.begin();
        awaiting.begin();
        millis += 150;
        awaiting.end();
        millis += 150;
        assertTrue(awaiting.lasts(LEAST));
        awaiting.end();
        millis += 60;
        assertFalse(awaiting.lasts(LEAST));
    }
}
