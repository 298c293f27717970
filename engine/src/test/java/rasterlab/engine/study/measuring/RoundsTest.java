package rasterlab.engine.study.measuring;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class RoundsTest {
    private long now;

    private Rounds rounds(int rounds, int most, long seconds) {
        var plan = new RoundPlan(rounds, most, Duration.ofSeconds(seconds), 3);
        return new Rounds(5, plan, () -> now);
    }

    /** Rounds that take that long each; load i takes i + 1 nanoseconds. */
    private static int made(Rounds rounds, Runnable each) {
        int made = 0;
        for (; rounds.more(); made++) {
            for (int load : rounds.order()) rounds.add(load, load + 1.0);
            each.run();
        }
        return made;
    }

    @Test
    void loadsThatAreToldApartNeedNoFurtherRound() {
        assertEquals(9, made(rounds(9, 36, 4), () -> {}));
    }

    @Test
    void budgetEndsThemButNotBeforeThereIsAnInterval() {
        assertEquals(8, made(rounds(9, 36, 4), () -> now += 3_000_000_000L));
    }

    @Test
    void withoutABudgetJustTheRoundsAreMade() {
        assertEquals(9, made(rounds(9, 9, 0), () -> now += 3_000_000_000L));
    }

    @Test
    void loadsThatAreNotToldApartGetMoreRoundsWhileThereIsTime() {
        Rounds rounds = rounds(9, 36, 4);
        int made = 0;
        for (; rounds.more(); made++)
            for (int load : rounds.order()) rounds.add(load, 10 + (made * 7 + load) % 5);
        assertEquals(36, made);
    }

    @Test
    void everyRoundHasAnOrderOfItsOwnAndASeedRepeatsThem() {
        Rounds one = rounds(9, 9, 0);
        Rounds again = rounds(9, 9, 0);
        var seen = new ArrayList<List<Integer>>();
        for (int round = 0; round < 9; round++) {
            seen.add(one.order());
            assertEquals(seen.get(round), again.order());
        }
        assertNotEquals(1, seen.stream().distinct().count());
    }

    @Test
    void aLostLoadHasNoFurtherTurn() {
        Rounds rounds = rounds(9, 9, 0);
        rounds.order();
        rounds.lose(2);
        assertFalse(rounds.order().contains(2));
        for (int load : List.of(0, 1, 3, 4)) rounds.lose(load);
        assertFalse(rounds.more(), "nothing is left");
    }

    @Test
    void fixedLoadTellsTheMachinesNoise() {
        Rounds rounds = rounds(9, 9, 0);
        assertEquals(1, rounds.noise());
        for (int i = 0; i < 9; i++) rounds.addFixed(i % 2 == 0 ? 1 : 2);
        assertEquals(2, rounds.noise());
    }

    @Test
    void warmUpEndsWhenNothingIsGained() {
        var stability = new Stability();
        for (double nanos : new double[] {100, 50, 20, 19.9, 20}) {
            stability.add(nanos);
            assertFalse(stability.isReached());
        }
        stability.add(30);
        assertTrue(stability.isReached());
    }
}
