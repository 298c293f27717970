package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;

/**
 * Draws as many chords as the curvature asks for and measures none of them, unlike {@link
 * FewestCurve}.
 *
 * <p>The corners lie on the parabolas, which have a tenth of the flatness for themselves, and the
 * chords the rest. It is nearly the fewest, but where the estimate is too small, a chord is farther
 * off than allowed: near cusps and turns by many times. Degrees above 3 are left to {@link
 * AdaptiveCurve}.
 *
 * <p>Source: R. Levien, Flattening quadratic Béziers, 2019, and the library kurbo, which draws so.
 */
public final class CurvatureUncheckedCurve implements SteppedCurve {
    private final AdaptiveCurve halving = new AdaptiveCurve();

    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        halving.at(curve, t, out);
    }

    @Override
    public void flatten(Curve curve, double flatness, CurvePoints out) {
        walk(curve, flatness).drain(out);
    }

    @Override
    public CurveWalk walk(Curve curve, double flatness) {
        return curve.degree() > 3 ? halving.walk(curve, flatness) : new Walk(curve, flatness);
    }

    @Override
    public String decisionFormula() {
        return "distance of the curve from the chord, in pixels; nothing is decided by it";
    }

    private static final class Walk extends CornersWalk {
        private ParabolaSteps steps;
        private double[] corners = {};

        Walk(Curve curve, double flatness) {
            super(curve, flatness);
        }

        @Override
        int chosen() {
            steps = new ParabolaSteps(cubic, left);
            int count = steps.count(1 - ParabolaSteps.OF_PARABOLAS);
            corners = steps.corners(count);
            return count;
        }

        @Override
        double[] corners() {
            return corners;
        }

        @Override
        double inX(double u) {
            return steps.onParabola(u)[0];
        }

        @Override
        double inY(double u) {
            return steps.onParabola(u)[1];
        }
    }
}
