package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;

/**
 * Base of forward differences in any kind of numbers: equal steps of t, and a fresh start in each
 * span.
 */
abstract class DifferencesCurve implements SteppedCurve {
    /** Doubles drift by less than this many roundings of a cubic in the steps that are allowed. */
    private static final double GROWTH = 0x1p14;

    private static final double UNEVEN = 1e-12;

    /** The point that goes on by one step at a time. */
    interface DifferencePoint {
        void step();

        double x();

        double y();
    }

    /**
     * A run at its first point.
     *
     * @param ofX differences of order 0 to the degree
     */
    abstract DifferencePoint start(double[] ofX, double[] ofY);

    @Override
    public final void at(Curve curve, double[] t, CurvePoints out) {
        CurveSpans.requireInside(t);
        PowerForm.requireDegree(curve);
        double step = equalStep(t) * curve.spans();
        int span = -1;
        DifferencePoint run = null;
        for (double each : t) {
            int index = CurveSpans.span(curve, each);
            if (index == span) run.step();
            else run = started(curve, index, CurveSpans.local(curve, each), step);
            span = index;
            out.point(run.x(), run.y());
        }
    }

    private DifferencePoint started(Curve curve, int span, double u, double step) {
        return start(
                ForwardDifferences.of(PowerForm.coefficients(curve, curve.x(), span), u, step),
                ForwardDifferences.of(PowerForm.coefficients(curve, curve.y(), span), u, step));
    }

    private static double equalStep(double[] t) {
        if (t.length < 2) return 0;
        double step = (t[t.length - 1] - t[0]) / (t.length - 1);
        for (int i = 0; i < t.length; i++)
            if (!(Math.abs(t[i] - (t[0] + i * step)) <= UNEVEN))
                throw new IllegalArgumentException(
                        "at[%d] must be %s, since forward differences need equal steps; got %s"
                                .formatted(i, t[0] + i * step, t[i]));
        return step;
    }

    @Override
    public final void flatten(Curve curve, double flatness, CurvePoints out) {
        walk(curve, flatness).drain(out);
    }

    @Override
    public final CurveWalk walk(Curve curve, double flatness) {
        PowerForm.requireDegree(curve);
        double left = Flatness.left(curve, flatness, GROWTH * PowerForm.growth(curve));
        return new Walk(curve, WangCount.ofAll(curve, new BezierPoints(curve), left));
    }

    @Override
    public String decisionFormula() {
        return "n = ⌈√(d·(d − 1)·|Δ²| / (8·flatness))⌉ steps in this span (Wang)";
    }

    private final class Walk implements CurveWalk {
        private final Curve curve;
        private final int[] steps;
        private DifferencePoint run;
        private int index;
        private int step = -1;

        Walk(Curve curve, int[] steps) {
            this.curve = curve;
            this.steps = steps;
        }

        @Override
        public boolean advance() {
            if (step == steps[index]) {
                if (index == steps.length - 1) return false;
                index++;
                step = 0;
                begin();
            }
            if (step < 0) begin();
            else run.step();
            step++;
            return true;
        }

        private void begin() {
            run = started(curve, index, 0, 1.0 / steps[index]);
        }

        @Override
        public double x() {
            return run.x();
        }

        @Override
        public double y() {
            return run.y();
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
