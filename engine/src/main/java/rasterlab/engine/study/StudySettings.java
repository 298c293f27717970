package rasterlab.engine.study;

import java.time.Duration;

/**
 * How long a study takes its time.
 *
 * @param warmUp time each method runs on each workload before it is timed
 * @param round the least time of one timed round
 * @param rounds number of timed rounds, at least 1; their median counts
 * @param wallLimit the longest that a method may take for one input
 */
public record StudySettings(Duration warmUp, Duration round, int rounds, Duration wallLimit) {
    public StudySettings {
        if (warmUp.isNegative())
            throw new IllegalArgumentException("warm-up must not be negative, got " + warmUp);
        requireSome(round, "round");
        requireSome(wallLimit, "wall limit");
        if (rounds < 1)
            throw new IllegalArgumentException("rounds must be at least 1, got " + rounds);
    }

    /** Settings for figures to quote: about 10 seconds for five methods on five workloads. */
    public static StudySettings thorough() {
        return new StudySettings(
                Duration.ofMillis(150), Duration.ofMillis(20), 11, Duration.ofSeconds(2));
    }

    /** Settings for a first look: about 2 seconds for five methods on five workloads. */
    public static StudySettings quick() {
        return new StudySettings(
                Duration.ofMillis(30), Duration.ofMillis(5), 7, Duration.ofSeconds(2));
    }

    /** Settings for all of a study but its times: one pass after one of warm-up. */
    public static StudySettings shortest() {
        return new StudySettings(Duration.ZERO, Duration.ofNanos(1), 1, quick().wallLimit());
    }

    private static void requireSome(Duration value, String name) {
        if (value.compareTo(Duration.ZERO) <= 0)
            throw new IllegalArgumentException(name + " must be longer than 0, got " + value);
    }
}
