package rasterlab.engine.study.measuring;

import java.time.Duration;

/**
 * How many rounds loads are measured in.
 *
 * @param rounds that are made in any case, but for those that the budget cuts; at least 1
 * @param most that are made where a pair of loads is not told apart, at least {@code rounds}
 * @param budget wall time after which no round begins, once there are {@value #LEAST}
 * @param seed of the order in which the loads of a round take turns
 */
public record RoundPlan(int rounds, int most, Duration budget, long seed) {
    /** The rounds that are made whatever time they take: of fewer the interval promises less. */
    public static final int LEAST = 8;

    public RoundPlan {
        if (rounds < 1)
            throw new IllegalArgumentException("rounds must be at least 1, got " + rounds);
        if (most < rounds)
            throw new IllegalArgumentException(
                    "most rounds must be at least " + rounds + ", got " + most);
        if (budget.isNegative())
            throw new IllegalArgumentException("budget must not be negative, got " + budget);
    }
}
