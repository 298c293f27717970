package rasterlab.engine.spline;

import java.util.List;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that put a function through points; each is a {@link SteppedSpline}. */
final class SplineMethods {
    private SplineMethods() {}

    static List<Method<SplineFunction>> all() {
        return List.of(cubic(), monotone());
    }

    private static Method<SplineFunction> cubic() {
        return new Method<>(
                "cubic",
                new About(
                        "μ·M[i−1] + 2·M[i] + λ·M[i+1] = 6·(δ[i] − δ[i−1])/(h[i−1] + h[i]) for the second"
                                + " derivatives M",
                        "after i steps the first i columns are zero below the diagonal",
                        "two steps per knot, O(m) time and memory",
                        "overshoots beside steep data; equal, unordered or not finite knots are"
                                + " refused with their index",
                        "J. H. Ahlberg, E. N. Nilson and J. L. Walsh, The Theory of Splines and Their"
                                + " Applications, 1967"),
                new CubicSpline());
    }

    private static Method<SplineFunction> monotone() {
        return new Method<>(
                "monotone",
                new About(
                        "slopes of parabolas, 0 at extremes, pulled back to α² + β² ≤ 9",
                        "all pieces so far lie between the values of their knots",
                        "one step per piece, O(m) time and memory",
                        "the second derivative jumps, and an extreme between two knots is cut off;"
                                + " knots are refused as by cubic",
                        "F. N. Fritsch and R. E. Carlson, Monotone piecewise cubic interpolation,"
                                + " SIAM Journal on Numerical Analysis 17(2), 1980"),
                new MonotoneSpline());
    }
}
