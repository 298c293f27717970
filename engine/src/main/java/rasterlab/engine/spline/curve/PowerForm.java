package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;

/**
 * The degrees that methods on powers of u can take: their coefficients grow like 3ⁿ and cancel
 * again, so that from degree {@value #MOST_DEGREE} on too few digits are left.
 */
final class PowerForm {
    static final int MOST_DEGREE = 10;

    private PowerForm() {}

    static void requireDegree(Curve curve) {
        if (curve.degree() > MOST_DEGREE)
            throw new IllegalArgumentException(
                    "points: degree must be from 0 to %d, where powers of u keep enough digits; got %d"
                            .formatted(MOST_DEGREE, curve.degree()));
    }

    /** How many times a cubic's rounding that of this degree is. */
    static double growth(Curve curve) {
        return Math.pow(3, Math.max(0, curve.degree() - 3));
    }

    /**
     * Coefficients of falling powers of u: C = M·G.
     *
     * @param points one coordinate of the control points
     */
    static double[] coefficients(Curve curve, double[] points, int span) {
        double[][] matrix = CurveMatrix.of(curve);
        var coefficients = new double[matrix.length];
        for (int row = 0; row < matrix.length; row++) {
            double sum = 0;
            for (int i = 0; i < matrix.length; i++) sum += matrix[row][i] * points[span + i];
            coefficients[row] = sum / CurveMatrix.divisor(curve);
        }
        return coefficients;
    }
}
