package rasterlab.engine.study.measuring;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import rasterlab.engine.study.measuring.PaceComparison.Order;

/** Compares loads whose true times are known. */
class PaceComparisonTest {
    private static final RoundPlan QUICK = new RoundPlan(12, 36, Duration.ofSeconds(4), 1);

    private static PaceComparison compared(Rounds rounds, int first, int second) {
        return PaceComparison.of(rounds.samples(first), rounds.samples(second), rounds.noise());
    }

    @Test
    void aMethodSlowedByAFifthIsFoundSlowerInNineteenOfTwentyRuns() {
        int found = 0;
        for (int run = 0; run < 20; run++) {
            Rounds rounds = new SimulatedLoads(run, 0.1, 10, 12).measured(QUICK);
            if (compared(rounds, 1, 0).order() == Order.SLOWER) found++;
        }
        assertTrue(found >= 19, found + " of 20");
    }

    @Test
    void noWrongOrderIsToldOnAVeryBusyMachine() {
        double[] truth = {10, 10.5, 11, 12, 13, 15, 20};
        int told = 0;
        for (int run = 0; run < 20; run++) {
            Rounds rounds = new SimulatedLoads(run, 0.8, truth).measured(QUICK);
            for (int slow = 1; slow < truth.length; slow++)
                for (int fast = 0; fast < slow; fast++) {
                    Order order = compared(rounds, slow, fast).order();
                    assertTrue(order != Order.FASTER, "run " + run + ": " + slow + ", " + fast);
                    if (order == Order.SLOWER) told++;
                }
        }
        assertTrue(told < 20 * 21 / 2, "it refuses most: " + told);
    }

    @Test
    void equalMethodsAreNeverPutInAnOrder() {
        for (int run = 0; run < 200; run++) {
            Rounds rounds = new SimulatedLoads(run, 0.3, 10, 10).measured(QUICK);
            Order order = compared(rounds, 0, 1).order();
            assertTrue(order == Order.ALIKE || order == Order.OPEN, "run " + run + ": " + order);
        }
    }

    @Test
    void intervalsThatPartByLessThanTheMachinesNoiseSayNothing() {
        var quick = new Samples();
        var slow = new Samples();
        for (int i = 0; i < 9; i++) {
            quick.add(10 + 0.01 * i);
            slow.add(12 + 0.01 * i);
        }
        assertEquals(Order.SLOWER, PaceComparison.of(slow, quick, 1.01).order());
        PaceComparison noisy = PaceComparison.of(slow, quick, 1.25);
        assertEquals(Order.OPEN, noisy.order());
        assertTrue(noisy.more().orElseThrow() >= 9, "what would settle it: " + noisy);
    }

    @Test
    void whatIsSettledNeedsNoMoreRounds() {
        var one = new Samples();
        for (int i = 0; i < 9; i++) one.add(10);
        PaceComparison same = PaceComparison.of(one, one, 1);
        assertEquals(Order.ALIKE, same.order());
        assertEquals(OptionalInt.empty(), same.more());
    }
}
