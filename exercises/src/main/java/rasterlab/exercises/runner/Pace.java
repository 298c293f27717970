package rasterlab.exercises.runner;

import rasterlab.engine.study.measuring.Samples;
import rasterlab.exercises.score.SpeedPoints;

/**
 * Nanoseconds per pixel of a method in its quickest round, since what else the machine does only
 * ever adds time; as the child tells it, whose clock leaves out the way there and back, and by the
 * clock of this process, which the child cannot move. Every round is kept.
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

    /** Stands for no time at all, which a clock may tell that cannot be believed. */
    private static final double LEAST = 1e-9;

    private final Samples own = new Samples();
    private final Samples wall = new Samples();

    void add(StudentRun.Timed round, long pixels) {
        double nanos = Math.max(LEAST, (double) round.nanos() / pixels);
        wall.add(nanos);
        own.add(Math.max(LEAST, Math.min(nanos, (double) round.own() / pixels)));
    }

    /** Nanoseconds per pixel as the child tells them; 0 where it tells that no time passed. */
    double own() {
        return own.least() <= LEAST ? 0 : own.least();
    }

    double wall() {
        return wall.least();
    }

    /** Whether further rounds would hardly tell more. */
    boolean isSettledBeside(Pace reference) {
        return isRepeated() && reference.isRepeated() && isCredibleBeside(reference);
    }

    /** Whether there was a round at all. */
    boolean isMeasured() {
        return !wall.isEmpty();
    }

    /** Whether another round was about as quick as the quickest. */
    boolean isRepeated() {
        return isMeasured() && own.nextToLeast() <= ALIKE * own.least();
    }

    /**
     * Whether the child's clock can be believed: it tells what that of this process does, but for
     * what keeps the reference's child from its work too.
     */
    boolean isCredibleBeside(Pace reference) {
        return own() > 0 && wall() / own() <= WIDER * reference.wall() / reference.own();
    }
}
