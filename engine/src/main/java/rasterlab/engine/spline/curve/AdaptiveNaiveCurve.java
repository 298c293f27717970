package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;

/**
 * Halving until the middle of a piece lies near its chord's line: a test that is easily fooled.
 *
 * <p>The middle of an S-curve lies on the chord however far both bows swing out; control points on
 * one line put the middle on it though the curve runs beyond the chord's ends. Kept to be looked at
 * beside {@link AdaptiveCurve}.
 */
public final class AdaptiveNaiveCurve implements SteppedCurve {
    private final DeCasteljauCurve triangle = new DeCasteljauCurve();

    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        triangle.at(curve, t, out);
    }

    @Override
    public void flatten(Curve curve, double flatness, CurvePoints out) {
        walk(curve, flatness).drain(out);
    }

    @Override
    public CurveWalk walk(Curve curve, double flatness) {
        return new HalvingWalk(curve, flatness, AdaptiveNaiveCurve::middleFromLine);
    }

    private static double middleFromLine(BezierPoints piece) {
        int n = piece.degree();
        double chordX = piece.x[n] - piece.x[0];
        double chordY = piece.y[n] - piece.y[0];
        BezierPoints second = piece.copy();
        second.firstHalf();
        double toX = second.x[0] - piece.x[0];
        double toY = second.y[0] - piece.y[0];
        double length = Math.hypot(chordX, chordY);
        if (length == 0) return Math.hypot(toX, toY);
        return Math.abs(chordX / length * toY - chordY / length * toX);
    }

    @Override
    public String decisionFormula() {
        return "distance of the piece's middle from its chord's line, in pixels";
    }
}
