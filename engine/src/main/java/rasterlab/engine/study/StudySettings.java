package rasterlab.engine.study;

import java.time.Duration;
import rasterlab.engine.study.measuring.RoundPlan;

/**
 * How long a study takes its time.
 *
 * @param warmUp the least time each method runs on each workload before it is timed; it runs on, up
 *     to {@value #LONGEST_WARM_UP} times as long, while it still becomes faster
 * @param round the least time of one timed round
 * @param rounds number of timed rounds, at least 1; their median counts
 * @param wallLimit the longest that a method may take for one input
 * @param budget wall time for the rounds of all methods: while some of it is left, up to {@value
 *     #MOST_TIMES} times the rounds are made to tell methods apart; zero for just the rounds
 * @param seed of the order in which the methods take turns
 */
public record StudySettings(
        Duration warmUp,
        Duration round,
        int rounds,
        Duration wallLimit,
        Duration budget,
        long seed) {
    /** How many times longer the warm-up of a method may be that still becomes faster. */
    static final int LONGEST_WARM_UP = 4;

    private static final int MOST_TIMES = 3;
    private static final long USUAL_SEED = 1;

    public StudySettings {
        if (warmUp.isNegative())
            throw new IllegalArgumentException("warm-up must not be negative, got " + warmUp);
        requireSome(round, "round");
        requireSome(wallLimit, "wall limit");
        if (rounds < 1)
            throw new IllegalArgumentException("rounds must be at least 1, got " + rounds);
        if (budget.isNegative())
            throw new IllegalArgumentException("budget must not be negative, got " + budget);
    }

    /** Settings of just so many rounds. */
    public StudySettings(Duration warmUp, Duration round, int rounds, Duration wallLimit) {
        this(warmUp, round, rounds, wallLimit, Duration.ZERO, USUAL_SEED);
    }

    /** Settings for figures to quote: about 15 seconds for five methods on five workloads. */
    public static StudySettings thorough() {
        return new StudySettings(
                Duration.ofMillis(150),
                Duration.ofMillis(20),
                15,
                Duration.ofSeconds(2),
                Duration.ofSeconds(30),
                USUAL_SEED);
    }

    /** Settings for a first look: about 3 seconds for five methods on five workloads. */
    public static StudySettings quick() {
        return new StudySettings(
                Duration.ofMillis(30),
                Duration.ofMillis(5),
                12,
                Duration.ofSeconds(2),
                Duration.ofSeconds(4),
                USUAL_SEED);
    }

    /** Settings for all of a study but its times: one pass after one of warm-up. */
    public static StudySettings shortest() {
        return new StudySettings(Duration.ZERO, Duration.ofNanos(1), 1, quick().wallLimit());
    }

    public StudySettings withBudget(Duration other) {
        return new StudySettings(warmUp, round, rounds, wallLimit, other, seed);
    }

    public StudySettings withRounds(int other) {
        return new StudySettings(warmUp, round, other, wallLimit, budget, seed);
    }

    public StudySettings withSeed(long other) {
        return new StudySettings(warmUp, round, rounds, wallLimit, budget, other);
    }

    /** The rounds that those ask for. */
    RoundPlan plan() {
        int most = budget.isZero() ? rounds : Math.max(rounds, MOST_TIMES * rounds);
        return new RoundPlan(rounds, most, budget, seed);
    }

    private static void requireSome(Duration value, String name) {
        if (value.compareTo(Duration.ZERO) <= 0)
            throw new IllegalArgumentException(name + " must be longer than 0, got " + value);
    }
}
