package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;
import rasterlab.engine.range.Bounds;

/**
 * One span at one u in the matrix form: point(u) = T·M·G with T = [uⁿ … u² u 1].
 *
 * <p>The arrays are its own and must not be changed.
 *
 * @param span from 0
 * @param u in [0, 1]
 * @param powers T, by falling powers
 * @param matrix M times {@code divisor}, all of it whole numbers
 * @param geometry G: a row of x and y for each control point (Hermite: points, then derivatives)
 * @param coefficients C = M·G: a row of x and y for each power, falling
 * @param weights T·M, one for each control point
 */
public record SpanForm(
        int span,
        double u,
        double[] powers,
        double[][] matrix,
        int divisor,
        double[][] geometry,
        double[][] coefficients,
        double[] weights) {
    public SpanForm {
        Bounds.requireAtLeast("span", span, 0);
        Bounds.require("u", u, 0, 1);
    }

    /**
     * @param t in [0, 1], over all spans
     * @throws IllegalArgumentException if t is not, or the degree is above {@value
     *     PowerForm#MOST_DEGREE}
     */
    public static SpanForm at(Curve curve, double t) {
        CurveSpans.requireInside(t);
        PowerForm.requireDegree(curve);
        int span = CurveSpans.span(curve, t);
        double u = CurveSpans.local(curve, t);
        double[][] matrix = CurveMatrix.of(curve);
        double divisor = CurveMatrix.divisor(curve);
        int rows = matrix.length;
        var powers = new double[rows];
        powers[rows - 1] = 1;
        for (int i = rows - 2; i >= 0; i--) powers[i] = powers[i + 1] * u;
        double[] x = PowerForm.coefficients(curve, curve.x(), span);
        double[] y = PowerForm.coefficients(curve, curve.y(), span);
        var geometry = new double[rows][];
        var coefficients = new double[rows][];
        var weights = new double[rows];
        for (int i = 0; i < rows; i++) {
            geometry[i] = new double[] {curve.x()[span + i], curve.y()[span + i]};
            coefficients[i] = new double[] {x[i], y[i]};
            for (int row = 0; row < rows; row++)
                weights[i] += powers[row] * matrix[row][i] / divisor;
        }
        return new SpanForm(
                span, u, powers, matrix, (int) divisor, geometry, coefficients, weights);
    }

    /** The weights at another u: the blending functions. */
    public double[] weightsAt(double other) {
        var weights = new double[powers.length];
        for (int i = 0; i < weights.length; i++) {
            double sum = 0;
            for (double[] row : matrix) sum = sum * other + row[i];
            weights[i] = sum / divisor;
        }
        return weights;
    }
}
