package rasterlab.exercises.runner.process;

import java.time.Duration;

/**
 * How long a child may take for one answer.
 *
 * @param processor processor time that it may use
 * @param wall time that may pass, so that one who waits or sleeps does not do so for ever
 */
public record TimeLimit(Duration processor, Duration wall) {
    /**
     * A limit on wall time and processor time alike, for a child that runs nothing of a student's.
     */
    public static TimeLimit wall(Duration limit) {
        return new TimeLimit(limit, limit);
    }
}
