package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;

/**
 * Base of all methods that compute a point from its u alone: {@code at} takes the t as they come,
 * {@code flatten} equal steps of Wang's count in each span.
 */
abstract class EvaluatedCurve implements SteppedCurve {
    /** One span, ready to be evaluated. */
    interface CurveSpan {
        /**
         * Computes the point at {@code u} in [0, 1].
         *
         * @param point receives x and y
         */
        void at(double u, double[] point);
    }

    /**
     * Prepares a span.
     *
     * @throws IllegalArgumentException if the method cannot draw this curve
     */
    abstract CurveSpan span(Curve curve, int index);

    /** How many times the rounding of de Casteljau's triangle this method rounds; at least 1. */
    double growth(Curve curve) {
        return 1;
    }

    @Override
    public final void at(Curve curve, double[] t, CurvePoints out) {
        CurveSpans.requireInside(t);
        var point = new double[2];
        int loaded = -1;
        CurveSpan span = null;
        for (double each : t) {
            int index = CurveSpans.span(curve, each);
            if (index != loaded) span = span(curve, index);
            loaded = index;
            span.at(CurveSpans.local(curve, each), point);
            out.point(point[0], point[1]);
        }
    }

    @Override
    public final void flatten(Curve curve, double flatness, CurvePoints out) {
        walk(curve, flatness).drain(out);
    }

    @Override
    public final CurveWalk walk(Curve curve, double flatness) {
        double left = Flatness.left(curve, flatness, growth(curve));
        return new Walk(curve, WangCount.ofAll(curve, new BezierPoints(curve), left));
    }

    @Override
    public String decisionFormula() {
        return "n = ⌈√(d·(d − 1)·|Δ²| / (8·flatness))⌉ steps in this span (Wang)";
    }

    private final class Walk implements CurveWalk {
        private final Curve curve;
        private final int[] steps;
        private final double[] point = new double[2];
        private CurveSpan span;
        private int index;
        private int step = -1;

        Walk(Curve curve, int[] steps) {
            this.curve = curve;
            this.steps = steps;
            span = span(curve, 0);
        }

        @Override
        public boolean advance() {
            if (step == steps[index]) {
                if (index == steps.length - 1) return false;
                index++;
                step = 0;
                span = span(curve, index);
            }
            step++;
            span.at((double) step / steps[index], point);
            return true;
        }

        @Override
        public double x() {
            return point[0];
        }

        @Override
        public double y() {
            return point[1];
        }

        @Override
        public double t() {
            return (index + (double) step / steps[index]) / steps.length;
        }

        @Override
        public double decision() {
            return steps[index];
        }
    }
}
