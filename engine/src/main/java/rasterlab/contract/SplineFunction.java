package rasterlab.contract;

/**
 * Finds a piecewise cubic function y(x) through given points.
 *
 * <p>Between knots i and i + 1 it is a + b·s + c·s² + d·s³ with s = x − x[i], so a = y[i]. It
 * passes through every point and its slope does not jump; which of all such functions it is, says
 * the {@link Promise}. Below, h[i] = x[i + 1] − x[i] is the width of piece i, and δ[i] = (y[i + 1]
 * − y[i]) / h[i] the slope of its secant.
 *
 * <p>The function's values are what counts, between the first knot and the last: where an error is
 * at most 10⁻¹² of the largest |value|, among those given and the right ones, it is rounding.
 */
@FunctionalInterface
public interface SplineFunction {
    /** The one function that is right. */
    enum Promise {
        /** The second derivative does not jump either: with the ends, the cubic spline. */
        SMOOTH,
        /**
         * The monotone cubic of Fritsch and Carlson, which stays between the values of its two
         * knots: the cubic of each piece by its values and slopes at both knots. The slope k[i] is
         * (h[i]·δ[i−1] + h[i−1]·δ[i]) / (h[i−1] + h[i]) at an inner knot, that of the parabola
         * through three points, or 0 where δ[i−1] and δ[i] have not the same sign. At the first
         * knot it is the given slope; for natural ends (3·δ[0] − k[1]) / 2, for not-a-knot ends
         * that of the parabola, and with two knots δ[0] for both; in each case 0 where it has not
         * the sign of δ[0]. At the last knot it is so in the mirror; periodic ends are one inner
         * knot. Then, from the first piece to the last, where k[i]² + k[i+1]² is above 9·δ[i]² both
         * are multiplied by 3·|δ[i]| / √(k[i]² + k[i+1]²); of periodic ends the smaller |slope| is
         * taken for both at last.
         */
        SHAPE
    }

    /**
     * The coefficients of all pieces.
     *
     * @param x the knots, at least 2, strictly increasing, finite
     * @param y one finite value for each knot
     * @param ends what holds at the first and the last knot; periodic needs y[0] = y[last]
     * @return a, b, c, d of piece 0, then of piece 1, …: 4·(x.length − 1) numbers
     * @throws IllegalArgumentException if the knots are not so; the message names the first wrong
     *     value by its index. A method may refuse, too, a width outside 10⁻⁷⁵ to 10⁷⁵, a |y| above
     *     10⁷⁵, values of which the largest |y| is below 10⁻⁷⁵ but not 0, and a |slope| at an end
     *     outside 10⁻¹⁵⁰ to 10¹⁵⁰ but not 0: there coefficients are beyond the doubles
     */
    double[] coefficients(double[] x, double[] y, SplineEnds ends);

    default Promise promise() {
        return Promise.SMOOTH;
    }
}
