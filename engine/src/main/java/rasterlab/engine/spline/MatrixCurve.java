package rasterlab.engine.spline;

import rasterlab.contract.Curve;

/**
 * A point as the control points' weighted mean: weights T·M for T = [uⁿ … u² u 1], then times G.
 *
 * <p>The weights are the blending functions; their sum is 1 but for Hermite's, where those of the
 * two points are.
 *
 * <p>Source: J. D. Foley and others, Computer Graphics: Principles and Practice, 1990, chapter 11.
 */
public final class MatrixCurve extends EvaluatedCurve {
    @Override
    double growth(Curve curve) {
        return PowerForm.growth(curve);
    }

    @Override
    Span span(Curve curve, int index) {
        PowerForm.requireDegree(curve);
        double[][] matrix = CurveMatrix.of(curve);
        double divisor = CurveMatrix.divisor(curve);
        return (u, point) -> {
            double x = 0;
            double y = 0;
            for (int i = 0; i < matrix.length; i++) {
                double weight = 0;
                double power = 1;
                for (int row = matrix.length - 1; row >= 0; row--) {
                    weight += power * matrix[row][i];
                    power *= u;
                }
                x += weight * curve.x()[index + i];
                y += weight * curve.y()[index + i];
            }
            point[0] = x / divisor;
            point[1] = y / divisor;
        };
    }
}
