package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.Curve;
import rasterlab.contract.Curve.Kind;
import rasterlab.engine.spline.exact.Polyline;

/** The steps to a point lead to the point that the method computes. */
class PointStepTest {
    private static final double[] X = {0, 40, 90, 160, 170, 30};
    private static final double[] Y = {8, 200, 16, 90, 88, 300};

    private static List<PointStep> steps(String method, Curve curve, double t) {
        var stepped = (SteppedPoint) new CurveTopic().method(method).implementation();
        return stepped.stepsAt(curve, t);
    }

    @ParameterizedTest(name = "{0} steps to another point")
    @ValueSource(strings = {"matrix", "horner", "de-casteljau"})
    void lastStepIsThePoint(String method) {
        for (Kind kind : List.of(Kind.BEZIER, Kind.CATMULL_ROM, Kind.B_SPLINE))
            for (double t : new double[] {0, 0.3, 0.5, 0.9, 1}) {
                var curve = new Curve(kind, X, Y);
                List<PointStep> steps = steps(method, curve, t);
                PointStep last = steps.get(steps.size() - 1);
                var point = new Polyline(1);
                new CurveTopic().method(method).implementation().at(curve, new double[] {t}, point);
                assertArrayEquals(new double[] {point.x(0)}, last.x(), kind + " at " + t);
                assertArrayEquals(new double[] {point.y(0)}, last.y(), kind + " at " + t);
            }
    }

    @Test
    void triangleHasOnePointLessInEachRow() {
        var curve = new Curve(Kind.BEZIER, new double[] {0, 8, 16, 24}, new double[] {0, 8, 8, 0});
        List<PointStep> steps = steps("de-casteljau", curve, 0.5);
        assertEquals(4, steps.size());
        assertArrayEquals(new double[] {4, 12, 20}, steps.get(1).x());
        assertArrayEquals(new double[] {4, 8, 4}, steps.get(1).y());
        assertArrayEquals(new double[] {6, 6}, steps.get(2).y());
        assertArrayEquals(new double[] {6}, steps.get(3).y());
    }

    @Test
    void weightsOfTheMatrixAreBernsteins() {
        var curve = new Curve(Kind.BEZIER, new double[] {1, 1, 1, 1}, new double[4]);
        double[] factors =
                steps("matrix", curve, 0.5).stream().mapToDouble(PointStep::factor).toArray();
        assertArrayEquals(new double[] {0.125, 0.375, 0.375, 0.125}, factors);
    }

    @Test
    void placesBesideTheCurveAreRefused() {
        var curve = new Curve(Kind.BEZIER, X, Y);
        for (String method : List.of("matrix", "horner", "de-casteljau"))
            assertThrows(IllegalArgumentException.class, () -> steps(method, curve, 1.5));
    }
}
