package rasterlab.exercises.runner;

import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.engine.study.measuring.RoundPlan;
import rasterlab.engine.study.measuring.Samples;
import rasterlab.engine.study.measuring.Stability;
import rasterlab.exercises.score.SpeedPoints;

/**
 * The pace of a program beside that of the reference, timed in turns on the same inputs: a round of
 * the one and the round of the other that follows make a pair, so that what slows the machine for a
 * while slows both, and the median of the pairs' ratios counts, with the interval in which it lies.
 *
 * <p>Nanoseconds per item are those that the child tells, whose clock leaves out the way there and
 * back, and those by the clock of this process, which the child cannot move. Every pair is kept.
 */
final class Pace {
    /** How many times the ratio may be off where further rounds are not worth their time. */
    private static final double NARROW = 1.1;

    /** How many times it may be off at the end: each band ends at twice the one before at least. */
    private static final double ROUGH = 2;

    /**
     * How many times wider than the reference's the gap between the clocks may be. Each band of
     * {@link SpeedPoints} ends at twice the one before at least, so a clock that tells a shorter
     * time by this much gains one band at most.
     */
    private static final double WIDER = 2;

    /** Stands for no time at all, which a clock may tell that cannot be believed. */
    private static final double LEAST = 1e-9;

    private final Clocks program = new Clocks();
    private final Clocks reference = new Clocks();

    /** Tells when both have become no faster for a while, or have had the time for it. */
    static final class WarmUp {
        private final Stability program = new Stability();
        private final Stability reference = new Stability();
        private final long longestNanos;

        /**
         * @param longestNanos wall time after which rounds count in any case
         */
        WarmUp(long longestNanos) {
            this.longestNanos = longestNanos;
        }

        /**
         * Takes a pair of rounds, and tells whether it counts.
         *
         * @param items that the program made, at least 1
         * @param elapsedNanos since the first pair was begun
         */
        boolean isOver(
                StudentRun.Timed ofProgram,
                StudentRun.Timed ofReference,
                long items,
                long elapsedNanos) {
            program.add((double) ofProgram.nanos() / items);
            reference.add((double) ofReference.nanos() / items);
            return program.isReached() && reference.isReached() || elapsedNanos > longestNanos;
        }
    }

    /** The two clocks that time one of both. */
    private static final class Clocks {
        private final Samples own = new Samples();
        private final Samples wall = new Samples();

        void add(StudentRun.Timed round, long items) {
            double nanos = Math.max(LEAST, (double) round.nanos() / items);
            wall.add(nanos);
            own.add(Math.max(LEAST, Math.min(nanos, (double) round.own() / items)));
        }

        double own() {
            return own.interval().median();
        }

        double wall() {
            return wall.interval().median();
        }
    }

    /**
     * Takes a pair of rounds.
     *
     * @param items that the program made, at least 1
     * @param referenceItems that the reference made, at least 1
     */
    void add(
            StudentRun.Timed ofProgram,
            long items,
            StudentRun.Timed ofReference,
            long referenceItems) {
        program.add(ofProgram, items);
        reference.add(ofReference, referenceItems);
    }

    /** Number of pairs. */
    int pairs() {
        return program.own.count();
    }

    /** How many times the reference's time the program takes, as the children tell it. */
    MedianInterval ratio() {
        return program.own.over(reference.own).interval();
    }

    /** The ratio by the clock of this process. */
    MedianInterval wallRatio() {
        return program.wall.over(reference.wall).interval();
    }

    /** Nanoseconds per item of the reference, as its child tells them. */
    double reference() {
        return reference.own();
    }

    /** The reference's time by the clock of this process. */
    double wallReference() {
        return reference.wall();
    }

    /** Whether both children tell that time passed. */
    boolean isTimed() {
        return program.own() > LEAST && reference.own() > LEAST;
    }

    /**
     * Whether further rounds would hardly tell more: the points are the same in all that can be.
     */
    boolean isSettled() {
        return pairs() > 1 && isCredible() && isTold(ratio());
    }

    /** Whether the ratio is known well enough to tell, should there be no further rounds. */
    boolean isRoughlyTold() {
        return pairs() >= RoundPlan.LEAST && isCredible() && ratio().factor() <= ROUGH;
    }

    private static boolean isTold(MedianInterval ratio) {
        return ratio.factor() <= NARROW || SpeedPoints.isOneBand(ratio.low(), ratio.high());
    }

    /**
     * Whether the child's clock can be believed: it tells what that of this process does, but for
     * what keeps the reference's child from its work too.
     */
    boolean isCredible() {
        return isTimed()
                && program.wall() / program.own() <= WIDER * reference.wall() / reference.own();
    }
}
