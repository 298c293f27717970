package rasterlab.engine.spline.exact;

import rasterlab.contract.Curve;

/**
 * A curve as so many points, each by its definition, that between two of them it hardly bends.
 *
 * <p>Bézier points are weighted by Bernstein's polynomials; the other kinds are cubics and are
 * known by their values at four places (Lagrange), computed exactly.
 */
public final class DenseCurve {
    private final Curve curve;

    public DenseCurve(Curve curve) {
        this.curve = curve;
    }

    /**
     * The curve from start to end.
     *
     * @param chords at least as many in all
     */
    public Polyline sampled(int chords) {
        int spans = curve.spans();
        int each = Math.max(2, (chords + spans - 1) / spans);
        var dense = new Polyline(Integer.MAX_VALUE);
        for (int span = 0; span < spans; span++) {
            double[] px = curve.x();
            double[] py = curve.y();
            if (curve.kind() != Curve.Kind.BEZIER) {
                px = known(span, true);
                py = known(span, false);
            }
            for (int i = span == 0 ? 0 : 1; i <= each; i++) {
                double[] weights = weights((double) i / each);
                dense.point(mean(weights, px), mean(weights, py));
            }
        }
        return dense;
    }

    /** Exact values at u = 0, ⅓, ⅔, 1. */
    private double[] known(int span, boolean horizontal) {
        var exact = new ExactCurve(curve);
        var values = new double[4];
        for (int i = 0; i < 4; i++) {
            double t = (span + i / 3.0) / curve.spans();
            values[i] = horizontal ? exact.x(t) : exact.y(t);
        }
        return values;
    }

    private double[] weights(double u) {
        return curve.kind() == Curve.Kind.BEZIER ? bernstein(curve.degree(), u) : lagrange(u);
    }

    private static double[] lagrange(double u) {
        double v = 3 * u;
        return new double[] {
            -(v - 1) * (v - 2) * (v - 3) / 6,
            v * (v - 2) * (v - 3) / 2,
            -v * (v - 1) * (v - 3) / 2,
            v * (v - 1) * (v - 2) / 6
        };
    }

    private static double[] bernstein(int n, double u) {
        var weights = new double[n + 1];
        double rising = 1;
        for (int i = 0; i <= n; i++) {
            weights[i] = rising;
            rising = rising * u * (n - i) / (i + 1);
        }
        double falling = 1;
        for (int i = n; i >= 0; i--) {
            weights[i] *= falling;
            falling *= 1 - u;
        }
        return weights;
    }

    private static double mean(double[] weights, double[] points) {
        double sum = 0;
        for (int i = 0; i < weights.length; i++) sum += weights[i] * points[i];
        return sum;
    }
}
