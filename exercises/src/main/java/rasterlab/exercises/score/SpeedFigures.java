package rasterlab.exercises.score;

import java.util.List;
import rasterlab.engine.study.measuring.MedianInterval;

/**
 * A student's speed and error beside those of the topic's methods, measured in one run.
 *
 * <p>An error is the largest one on the open cases for accuracy, in the topic's unit, as in its
 * study; it is infinite where items are missing or extra, or where there is no answer.
 *
 * @param ratio of the student's time per item to that of the reference, with the interval in which
 *     it lies
 * @param reference nanoseconds per item of the reference, above 0
 * @param error the student's
 * @param methods those of the topic that are kept as right ones and answer these inputs
 */
public record SpeedFigures(
        MedianInterval ratio, double reference, double error, List<MethodSpeed> methods) {
    /**
     * A method of the topic.
     *
     * @param ratio of its time per item to that of the reference, above 0
     */
    public record MethodSpeed(String name, MedianInterval ratio, double error) {
        public MethodSpeed {
            requireTime(name, ratio.low());
            requireTime(name, ratio.high());
            requireError(name, error);
        }

        /** A method of whose ratio no interval is known. */
        public MethodSpeed(String name, double ratio, double error) {
            this(name, MedianInterval.exact(ratio), error);
        }
    }

    public SpeedFigures {
        requireTime("student", ratio.low());
        requireTime("student", ratio.high());
        requireTime("reference", reference);
        requireError("student", error);
        methods = List.copyOf(methods);
    }

    /** Figures of which no interval is known. */
    public SpeedFigures(double nanos, double reference, double error, List<MethodSpeed> methods) {
        this(MedianInterval.exact(nanos / reference), reference, error, methods);
    }

    private static void requireTime(String whose, double time) {
        if (!(time > 0 && Double.isFinite(time)))
            throw new IllegalArgumentException(
                    "time of " + whose + " must be above 0, got " + time);
    }

    private static void requireError(String whose, double error) {
        if (!(error >= 0))
            throw new IllegalArgumentException(
                    "error of " + whose + " must be at least 0, got " + error);
    }

    /** The student's nanoseconds per item. */
    public double nanos() {
        return ratio.median() * reference;
    }
}
