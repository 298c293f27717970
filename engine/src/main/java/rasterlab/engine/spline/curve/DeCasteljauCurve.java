package rasterlab.engine.spline.curve;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.contract.Curve;

/**
 * Means of means: each row of the triangle divides the sides of the row above in u : (1 − u), and
 * the last row is the point.
 *
 * <p>Only means of control points are taken, so that nothing grows and no degree is too high: n·(n
 * + 1)/2 means per coordinate.
 *
 * <p>{@link BezierPoints} turns a span of any kind of curve into Bézier control points; {@link
 * EvaluatedCurve} goes along the curve and says for which u a point is asked.
 *
 * <p>Source: P. de Casteljau, Outillages méthodes calcul, Citroën, 1959; W. Boehm, A. Müller, On de
 * Casteljau's algorithm, Computer Aided Geometric Design 16, 1999, pp. 587–605.
 */
public final class DeCasteljauCurve extends EvaluatedCurve implements SteppedPoint {
    @Override
    CurveSpan span(Curve curve, int index) {
        var points = new BezierPoints(curve);
        points.load(index);
        var x = new double[points.x.length];
        var y = new double[points.x.length];
        return (u, point) -> {
            System.arraycopy(points.x, 0, x, 0, x.length);
            System.arraycopy(points.y, 0, y, 0, y.length);
            for (int row = x.length - 1; row > 0; row--) nextRow(x, y, row, u);
            point[0] = x[0];
            point[1] = y[0];
        };
    }

    /** Divides each side of a row of {@code row} + 1 points; those in front are the next row. */
    private static void nextRow(double[] x, double[] y, int row, double u) {
        for (int i = 0; i < row; i++) {
            x[i] = (1 - u) * x[i] + u * x[i + 1];
            y[i] = (1 - u) * y[i] + u * y[i + 1];
        }
    }

    /** The triangle row by row, the control points first. */
    @Override
    public List<PointStep> stepsAt(Curve curve, double t) {
        CurveSpans.requireInside(t);
        var points = new BezierPoints(curve);
        points.load(CurveSpans.span(curve, t));
        double u = CurveSpans.local(curve, t);
        double[] x = points.x.clone();
        double[] y = points.y.clone();
        var steps = new ArrayList<PointStep>();
        steps.add(new PointStep("Bézier points", u, x.clone(), y.clone()));
        for (int row = x.length - 1; row > 0; row--) {
            nextRow(x, y, row, u);
            steps.add(
                    new PointStep(
                            "(1 − u)·P[i] + u·P[i + 1]",
                            u,
                            Arrays.copyOf(x, row),
                            Arrays.copyOf(y, row)));
        }
        return steps;
    }
}
