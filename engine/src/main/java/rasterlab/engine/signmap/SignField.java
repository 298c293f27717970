package rasterlab.engine.signmap;

import java.util.stream.IntStream;
import rasterlab.engine.predicate.Spacing;

/**
 * The square of neighbouring points that a map has a pixel for.
 *
 * @param size points in each row and column
 * @param left the least x, above 0
 * @param low the least y, above 0
 */
record SignField(Spacing spacing, int size, double left, double low) {
    SignField {
        requireAboveZero("left", left);
        requireAboveZero("low", low);
    }

    private static void requireAboveZero(String name, double value) {
        if (!(value > 0))
            throw new IllegalArgumentException(name + " must be above 0, got " + value);
    }

    /** The answers for all points, row after row from the lowest. */
    byte[] answers(Sign sign) {
        var answers = new byte[size * size];
        IntStream.range(0, answers.length)
                .parallel()
                .forEach(
                        i ->
                                answers[i] =
                                        (byte)
                                                sign.of(
                                                        spacing.above(left, i % size),
                                                        spacing.above(low, i / size)));
        return answers;
    }
}
