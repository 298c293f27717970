package rasterlab.app.polygon.outcome;

import rasterlab.engine.study.Deviation;

/**
 * The outcome of one method for a figure.
 *
 * @param message what it said when it refused or crashed, in English; "" otherwise
 * @param deviation from the exact answer
 */
public record MethodOutcome(
        String method,
        MethodEnding ending,
        String message,
        Deviation deviation,
        PolygonAnswer answer) {
    /** How it came to its end. */
    public enum MethodEnding {
        ENDED,
        /** The method threw for what it cannot do. */
        REFUSED,
        CRASHED,
        /** The method went on beyond all bounds and was stopped. */
        ENDLESS
    }

    /** Whether it is what the exact answer is. */
    public boolean isRight() {
        return ending == MethodEnding.ENDED && deviation.exact();
    }

    public int steps() {
        return answer.steps();
    }
}
