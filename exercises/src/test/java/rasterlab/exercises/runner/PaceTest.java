package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalInt;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.exercises.score.SpeedPoints;

/** Simulated rounds of a program and of the reference tell the program's speed. */
class PaceTest {
    private static final int PIXELS = 100;

    @Test
    @DisplayName("a round in which the machine did something else decides")
    void theMedianOfThePairsCounts() {
        Pace pace = new Pace();
        for (long nanos : new long[] {300, 310, 9_000, 290, 300}) add(pace, nanos, 100);
        assertEquals(3, pace.ratio().median());
        assertEquals(1, pace.reference());
    }

    @Test
    @DisplayName("what slows both for a while makes one of them slower")
    void pairsAreComparedEachWithItself() {
        Pace pace = new Pace();
        for (int i = 1; i <= 9; i++) add(pace, 300L * i, 200L * i);
        assertEquals(MedianInterval.exact(1.5), pace.ratio());
        assertTrue(pace.isSettled());
    }

    @Test
    @DisplayName("a single pair decides, although no other was alike")
    void oneRoundIsNotEnough() {
        Pace pace = new Pace();
        add(pace, 300, 200);
        assertFalse(pace.isSettled());
        add(pace, 300, 200);
        assertTrue(pace.isSettled());
    }

    @Test
    @DisplayName("a program is called slower though its interval reaches to where it is not")
    void onlyPartedIntervalsTellThatItIsSlower() {
        Pace pace = new Pace();
        for (int i = 0; i < 8; i++) add(pace, i < 3 ? 280 : 400, 200);
        assertEquals(2, pace.ratio().median());
        assertFalse(pace.isSettled(), "1.4 to 2 times is in two bands");
        assertEquals(0, SpeedPoints.band(pace.ratio().low(), OptionalInt.empty()));
        for (int i = 0; i < 40; i++) add(pace, 400, 200);
        assertTrue(pace.isSettled());
        assertEquals(1, SpeedPoints.band(pace.ratio().low(), OptionalInt.empty()));
    }

    @Test
    @DisplayName("a busy machine's rough ratio counts for nothing, or a mere guess for a ratio")
    void ratioThatIsOffByLessThanTwoTimesIsTold() {
        Pace rough = new Pace();
        Pace guess = new Pace();
        for (int i = 0; i < 12; i++) {
            add(rough, 200 + 40 * (i % 6), 200);
            add(guess, 100L << i % 6, 200);
        }
        assertTrue(rough.isRoughlyTold() && !rough.isSettled(), rough.ratio().toString());
        assertFalse(guess.isRoughlyTold(), guess.ratio().toString());
    }

    @Test
    @DisplayName("rounds on a busy machine give the same program other points each time")
    void noiseOfBothChangesNoBand() {
        for (double truth : new double[] {0.8, 2.2, 5, 20})
            for (long seed = 0; seed < 200; seed++) {
                var random = new Random(seed);
                Pace pace = new Pace();
                for (int i = 0; i < 12; i++) {
                    double busy = 1 + 4 * random.nextDouble();
                    double own = 1 + 0.1 * random.nextGaussian() * random.nextDouble();
                    add(pace, Math.round(truth * own * busy * 1e5), Math.round(busy * 1e5));
                }
                assertEquals(
                        SpeedPoints.band(truth, OptionalInt.empty()),
                        SpeedPoints.band(pace.ratio().low(), OptionalInt.empty()),
                        "truth " + truth + ", seed " + seed);
            }
    }

    @Test
    @DisplayName("a child that tells a shorter time than it took is believed")
    void aChildIsHeldToTheWallClock() {
        assertTrue(paceOf(375, 300, 250, 200).isCredible());
        assertFalse(paceOf(900, 3, 250, 200).isCredible());
        assertFalse(paceOf(900, -3, 250, 200).isCredible());
        assertFalse(paceOf(900, -3, 250, 200).isSettled());
        Pace longer = paceOf(900, 5000, 900, 900);
        assertEquals(1, longer.ratio().median(), "longer than the wall clock");
        assertEquals(4.5, paceOf(900, 3, 200, 200).wallRatio().median());
    }

    @Test
    @DisplayName("on a busy machine no child is believed")
    void whatDelaysTheReferenceIsNoReasonForDoubt() {
        assertTrue(paceOf(1500, 300, 800, 200).isCredible());
    }

    @Test
    @DisplayName("rounds that Java still compiles in count, or none does where they last too long")
    void roundsCountOnceTheyBecomeNoFaster() {
        var warmUp = new Pace.WarmUp(1_000);
        long[] nanos = {900, 500, 300, 295, 294, 296, 295};
        int counted = 0;
        for (long one : nanos)
            if (warmUp.isOver(timed(one, one), timed(200, 200), PIXELS, 10)) counted++;
        assertEquals(2, counted);
        assertTrue(new Pace.WarmUp(1_000).isOver(timed(900, 900), timed(200, 200), PIXELS, 1_001));
    }

    /** A pair whose clocks agree. */
    private static void add(Pace pace, long program, long reference) {
        pace.add(timed(program, program), PIXELS, timed(reference, reference), PIXELS);
    }

    private static Pace paceOf(long wall, long own, long referenceWall, long referenceOwn) {
        Pace pace = new Pace();
        for (int i = 0; i < 2; i++)
            pace.add(timed(wall, own), PIXELS, timed(referenceWall, referenceOwn), PIXELS);
        return pace;
    }

    private static StudentRun.Timed timed(long wall, long own) {
        return new StudentRun.Timed(wall, own, TimedBatch.NOTHING, 0, "", false);
    }
}
