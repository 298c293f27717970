package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** Which rounds a method's speed is told by. */
class PaceTest {
    private static final int PIXELS = 100;

    @Test
    @DisplayName("a round in which the machine did something else counts")
    void theQuickestRoundCounts() {
        Pace pace = rounds(900, 300, 500, 310);
        assertEquals(3, pace.own());
    }

    @Test
    @DisplayName("a single round decides, although no other was alike")
    void oneRoundIsNotEnough() {
        assertFalse(rounds(900, 300, 500).isSettledBeside(rounds(200, 200)));
        assertFalse(rounds(300, 300).isSettledBeside(rounds(1500, 200)), "the reference's");
        assertTrue(rounds(900, 300, 500, 310).isSettledBeside(rounds(200, 200)));
    }

    @Test
    @DisplayName("a reference that was never timed has settled")
    void noRoundSettlesNothing() {
        assertFalse(new Pace().isRepeated());
        assertFalse(rounds(200, 200).isSettledBeside(new Pace()));
    }

    @Test
    @DisplayName("a child that tells a shorter time than it took is believed")
    void aChildIsHeldToTheWallClock() {
        Pace reference = told(250, 200);
        assertTrue(told(375, 300).isCredibleBeside(reference));
        assertFalse(told(900, 3).isCredibleBeside(reference));
        assertFalse(told(900, -3).isCredibleBeside(reference));
        assertEquals(9, told(900, 5000).own(), "longer than the wall clock");
    }

    @Test
    @DisplayName("on a busy machine no child is believed")
    void whatDelaysTheReferenceIsNoReasonForDoubt() {
        assertTrue(told(1500, 300).isCredibleBeside(told(800, 200)));
    }

    /** A pace with a wall clock that agrees with the child's. */
    private static Pace rounds(long... nanos) {
        Pace pace = new Pace();
        for (long one : nanos) pace.add(timed(one, one), PIXELS);
        return pace;
    }

    private static Pace told(long wall, long own) {
        Pace pace = new Pace();
        pace.add(timed(wall, own), PIXELS);
        return pace;
    }

    private static StudentRun.Timed timed(long wall, long own) {
        return new StudentRun.Timed(wall, own, TimedBatch.NOTHING, 0, "", false);
    }
}
