package rasterlab.exercises.runner;

import rasterlab.exercises.score.SpeedPoints;

/**
 * Nanoseconds per pixel of a method in its quickest round, since what else the machine does only
 * ever adds time; as the child tells it, whose clock leaves out the way there and back, and by the
 * clock of this process, which the child cannot move.
 */
final class Pace {
    /**
     * Two rounds that differ by less say the same: the ratio of two such paces is off by a tenth at
     * most, and each band of {@link SpeedPoints} ends at twice the one before at least.
     */
    private static final double ALIKE = 1.05;

    /**
     * How many times wider than the reference's the gap between the clocks may be. Each band of
     * {@link SpeedPoints} ends at twice the one before at least, so a clock that tells a shorter
     * time by this much gains one band at most.
     */
    private static final double WIDER = 2;

    private double own = Double.MAX_VALUE;
    private double nextOwn = Double.MAX_VALUE;
    private double wall = Double.MAX_VALUE;

    void add(StudentRun.Timed round, long pixels) {
        double nanos = (double) round.nanos() / pixels;
        double told = Math.max(0, Math.min(nanos, (double) round.own() / pixels));
        wall = Math.min(wall, nanos);
        nextOwn = Math.min(nextOwn, Math.max(own, told));
        own = Math.min(own, told);
    }

    double own() {
        return own;
    }

    double wall() {
        return wall;
    }

    /** Whether further rounds would hardly tell more. */
    boolean isSettledBeside(Pace reference) {
        return isRepeated() && reference.isRepeated() && isCredibleBeside(reference);
    }

    /** Whether there was a round at all. */
    boolean isMeasured() {
        return wall < Double.MAX_VALUE;
    }

    /** Whether another round was about as quick as the quickest. */
    boolean isRepeated() {
        return isMeasured() && nextOwn <= ALIKE * own;
    }

    /**
     * Whether the child's clock can be believed: it tells what that of this process does, but for
     * what keeps the reference's child from its work too.
     */
    boolean isCredibleBeside(Pace reference) {
        return own > 0 && wall / own <= WIDER * reference.wall / reference.own;
    }
}
