package rasterlab.contract;

/**
 * Finds the piecewise cubic function through given points.
 *
 * <p>Between knots i and i + 1 it is a + b·s + c·s² + d·s³ with s = x − x[i]. It passes through
 * every point and its slope does not jump; what else it keeps to is its {@link Promise}.
 */
@FunctionalInterface
public interface SplineFunction {
    /** What a function keeps to beside passing through the points without a jump in slope. */
    enum Promise {
        /** The second derivative does not jump either: the cubic spline, of which there is one. */
        SMOOTH,
        /** Between two knots it stays between their two values: no overshoot. */
        SHAPE
    }

    /**
     * The coefficients of all pieces.
     *
     * @param x the knots, at least 2, strictly increasing, finite
     * @param y one finite value for each knot
     * @param ends what holds at the first and the last knot; periodic needs y[0] = y[last]
     * @return a, b, c, d of piece 0, then of piece 1, …: 4·(x.length − 1) numbers
     * @throws IllegalArgumentException if the knots are not so, or the coefficients cannot be
     *     computed in doubles; the message names the first wrong value by its index
     */
    double[] coefficients(double[] x, double[] y, SplineEnds ends);

    default Promise promise() {
        return Promise.SMOOTH;
    }
}
