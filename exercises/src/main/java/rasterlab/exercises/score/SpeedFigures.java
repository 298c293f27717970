package rasterlab.exercises.score;

import java.util.List;

/**
 * A student's speed and error beside those of the topic's methods, measured in one run.
 *
 * <p>An error is the largest one on the open cases for accuracy, in the topic's unit, as in its
 * study; it is infinite where items are missing or extra, or where there is no answer.
 *
 * @param nanos the student's time per item, above 0
 * @param reference that of the reference
 * @param error the student's
 * @param methods those of the topic that are kept as right ones and answer these inputs
 */
public record SpeedFigures(double nanos, double reference, double error, List<Method> methods) {
    /**
     * A method of the topic.
     *
     * @param ratio of its time per item to that of the reference, above 0
     */
    public record Method(String name, double ratio, double error) {
        public Method {
            requireTime(name, ratio);
            requireError(name, error);
        }
    }

    public SpeedFigures {
        requireTime("student", nanos);
        requireTime("reference", reference);
        requireError("student", error);
        methods = List.copyOf(methods);
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

    /** How many times the reference's time the student's method takes. */
    public double ratio() {
        return nanos / reference;
    }
}
