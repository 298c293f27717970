package rasterlab.engine.spline.curve;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.Curve;

/**
 * A point as the control points' weighted mean: weights T·M for T = [uⁿ … u² u 1], then times G.
 *
 * <p>The weights are the blending functions; their sum is 1 but for Hermite's, where those of the
 * two points are.
 *
 * <p>Source: J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics: Principles and
 * Practice, 1990, chapter 11.
 */
public final class MatrixCurve extends EvaluatedCurve implements SteppedPoint {
    @Override
    double growth(Curve curve) {
        return PowerForm.growth(curve);
    }

    @Override
    CurveSpan span(Curve curve, int index) {
        PowerForm.requireDegree(curve);
        double[][] matrix = CurveMatrix.of(curve);
        double divisor = CurveMatrix.divisor(curve);
        return (u, point) -> {
            double x = 0;
            double y = 0;
            for (int i = 0; i < matrix.length; i++) {
                double weight = weight(matrix, i, u);
                x += weight * curve.x()[index + i];
                y += weight * curve.y()[index + i];
            }
            point[0] = x / divisor;
            point[1] = y / divisor;
        };
    }

    /** The column of control point {@code i} of T·M. */
    private static double weight(double[][] matrix, int i, double u) {
        double weight = 0;
        double power = 1;
        for (int row = matrix.length - 1; row >= 0; row--) {
            weight += power * matrix[row][i];
            power *= u;
        }
        return weight;
    }

    /** One more control point in each step, its weight as the factor. */
    @Override
    public List<PointStep> stepsAt(Curve curve, double t) {
        CurveSpans.requireInside(t);
        PowerForm.requireDegree(curve);
        int span = CurveSpans.span(curve, t);
        double[][] matrix = CurveMatrix.of(curve);
        double divisor = CurveMatrix.divisor(curve);
        var steps = new ArrayList<PointStep>();
        double x = 0;
        double y = 0;
        for (int i = 0; i < matrix.length; i++) {
            double weight = weight(matrix, i, CurveSpans.local(curve, t));
            x += weight * curve.x()[span + i];
            y += weight * curve.y()[span + i];
            String text = "plus weight times G[" + i + "]";
            steps.add(PointStep.of(text, weight / divisor, x / divisor, y / divisor));
        }
        return steps;
    }
}
