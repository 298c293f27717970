package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import rasterlab.contract.Curve;
import rasterlab.contract.Curve.Kind;
import rasterlab.engine.spline.exact.Polyline;

/** The worked numbers of chapter 8. */
class CurveMatrixTest {
    @Test
    void chapter8HermiteTimesHermiteOfBezierIsBezier() {
        double[][] product = new double[4][4];
        for (int row = 0; row < 4; row++)
            for (int column = 0; column < 4; column++)
                for (int k = 0; k < 4; k++)
                    product[row][column] +=
                            CurveMatrix.hermite()[row][k]
                                    * CurveMatrix.hermiteOfBezier()[k][column];
        assertArrayEquals(CurveMatrix.bezier(3), product);
    }

    @Test
    void chapter8BezierMatrix() {
        double[][] printed = {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}};
        assertArrayEquals(printed, CurveMatrix.bezier(3));
    }

    @Test
    void chapter8HermiteMatrixInvertsItsConditions() {
        double[][] conditions = {{0, 0, 0, 1}, {1, 1, 1, 1}, {0, 0, 1, 0}, {3, 2, 1, 0}};
        double[][] hermite = CurveMatrix.hermite();
        for (int row = 0; row < 4; row++)
            for (int column = 0; column < 4; column++) {
                double sum = 0;
                for (int k = 0; k < 4; k++) sum += conditions[row][k] * hermite[k][column];
                assertEquals(row == column ? 1 : 0, sum, row + ", " + column);
            }
    }

    @Test
    void weightsOfPointsAddUpToOne() {
        for (int degree = 0; degree <= PowerForm.MOST_DEGREE; degree++)
            assertRows(CurveMatrix.bezier(degree), 1);
        assertRows(CurveMatrix.twiceCatmullRom(), 2);
        assertRows(CurveMatrix.sixBSpline(), 6);
    }

    private static void assertRows(double[][] matrix, double constant) {
        for (int row = 0; row < matrix.length; row++) {
            double sum = 0;
            for (double each : matrix[row]) sum += each;
            assertEquals(row == matrix.length - 1 ? constant : 0, sum, "row " + row);
        }
    }

    @Test
    void chapter8ErratumFirstWeightAtOneHalfIsAnEighthAndNotSevenEighths() {
        var curve = new Curve(Kind.BEZIER, new double[] {1, 0, 0, 0}, new double[4]);
        assertEquals(0.125, half(new MatrixCurve(), curve));
        assertEquals(0.875, half(new BlendingTextbookCurve(), curve));
    }

    @Test
    void chapter8HermiteLeavesAndArrivesAlongItsDerivatives() {
        double[] x = {0, 1, 4, -4};
        var curve = new Curve(Kind.HERMITE, x, new double[4]);
        // ½·0 + ½·1 + ⅛·4 + (−⅛)·(−4)
        assertEquals(1.5, half(new MatrixCurve(), curve));
        assertEquals(1.5, half(new BlendingTextbookCurve(), curve));
        assertEquals(1.5, half(new DeCasteljauCurve(), curve), 1e-15);
    }

    @Test
    void curvesOfOtherKindsPassWhereTheyMust() {
        double[] x = {0, 6, 12, 36};
        assertEquals(6, at(new HornerCurve(), new Curve(Kind.CATMULL_ROM, x, x), 0));
        assertEquals(12, at(new HornerCurve(), new Curve(Kind.CATMULL_ROM, x, x), 1));
        assertEquals(6, at(new HornerCurve(), new Curve(Kind.B_SPLINE, x, x), 0));
        assertEquals(15, at(new HornerCurve(), new Curve(Kind.B_SPLINE, x, x), 1));
    }

    private static double half(EvaluatedCurve method, Curve curve) {
        return at(method, curve, 0.5);
    }

    private static double at(EvaluatedCurve method, Curve curve, double t) {
        var points = new Polyline(1);
        method.at(curve, new double[] {t}, points);
        return points.x(0);
    }
}
