package rasterlab.engine.predicate;

import java.util.Optional;

/**
 * A question about a point that is answered by yes or no, in a scene where the point lies on the
 * border between both, but for its last digits.
 *
 * @param <I> one input of a topic
 * @param <O> one output of it
 */
public interface PointQuestion<I, O> {
    /** The point at half, where most scenes begin: its neighbours above are one spacing apart. */
    double HALF = 0.5;

    /** Points in each row and column of a map; fewer where the reference is slow. */
    default int size() {
        return 128;
    }

    /** The least x of the points asked about, above 0. */
    double left(Spacing spacing);

    /** The least y of the points asked about, above 0. */
    double low(Spacing spacing);

    /** The numbers that a method computes with. */
    default Spacing spacing(String method) {
        return Spacing.DOUBLE;
    }

    /** The scene with its point at (x, y). */
    I input(Spacing spacing, double x, double y);

    /** Whether an answer to such an input is yes. */
    boolean yes(O output);

    /** Returns what is right, where that is found sooner than an exact answer; else empty. */
    default Optional<Boolean> right(I input) {
        return Optional.empty();
    }
}
