package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.Curve;
import rasterlab.contract.Curve.Kind;

class CurvePlaceTest {
    private static final double[] X = {10, 60, 180, 250, 90};
    private static final double[] Y = {200, 20, 40, 190, 20};

    static Stream<Arguments> curves() {
        return Stream.of(
                argumentSet("a degree's factor is forgotten", Kind.BEZIER, 5),
                argumentSet("a parabola is taken for a cubic", Kind.BEZIER, 3),
                argumentSet("Hermite's derivatives are taken for points", Kind.HERMITE, 4),
                argumentSet("the second span is the first", Kind.CATMULL_ROM, 5),
                argumentSet("a sixth is forgotten", Kind.B_SPLINE, 5));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("curves")
    void derivativesAreTheLimitsOfDifferences(Kind kind, int points) {
        var curve = new Curve(kind, Arrays.copyOf(X, points), Arrays.copyOf(Y, points));
        int span = curve.spans() - 1;
        double h = 1e-4;
        CurvePlace before = CurvePlace.of(curve, span, 0.3 - h);
        CurvePlace here = CurvePlace.of(curve, span, 0.3);
        CurvePlace after = CurvePlace.of(curve, span, 0.3 + h);
        assertEquals((after.x() - before.x()) / (2 * h), here.dx(), 1e-3);
        assertEquals((after.y() - before.y()) / (2 * h), here.dy(), 1e-3);
        assertEquals((after.dx() - before.dx()) / (2 * h), here.ddx(), 1e-3);
        assertEquals((after.dy() - before.dy()) / (2 * h), here.ddy(), 1e-3);
    }

    /** Four cubics nearly make a circle; its radius is 100, turned from x to y. */
    @Test
    void curvatureOfACircleIsOneOverItsRadius() {
        double k = 100 * 4 * (Math.sqrt(2) - 1) / 3;
        var quarter =
                new Curve(
                        Kind.BEZIER, new double[] {100, 100, k, 0}, new double[] {0, k, 100, 100});
        for (double u = 0; u <= 1; u += 0.125)
            assertEquals(0.01, CurvePlace.of(quarter, 0, u).curvature(), 3e-4, "u = " + u);
        var back =
                new Curve(
                        Kind.BEZIER, new double[] {0, k, 100, 100}, new double[] {100, 100, k, 0});
        assertEquals(-0.01, CurvePlace.of(back, 0, 0.5).curvature(), 3e-4);
    }

    @Test
    void cuspHasNoCurvature() {
        var point = new Curve(Kind.BEZIER, new double[] {7, 7, 7, 7}, new double[] {4, 4, 4, 4});
        assertEquals(0, CurvePlace.of(point, 0, 0.5).speed());
        assertTrue(Double.isNaN(CurvePlace.of(point, 0, 0.5).curvature()));
    }

    @Test
    void lastPointBelongsToTheLastSpan() {
        var curve = new Curve(Kind.CATMULL_ROM, X, Y);
        assertEquals(1, CurvePlace.at(curve, 1).span());
        assertEquals(1, CurvePlace.at(curve, 1).u());
        assertEquals(0, CurvePlace.at(curve, 0.5).u());
    }

    @Test
    void placesOutsideAreRefused() {
        var curve = new Curve(Kind.CATMULL_ROM, X, Y);
        for (double outside : new double[] {-0.1, 1.1, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> CurvePlace.at(curve, outside));
            var refused =
                    assertThrows(
                            IllegalArgumentException.class, () -> CurvePlace.of(curve, 0, outside));
            assertTrue(refused.getMessage().contains("" + outside), refused.getMessage());
        }
        assertThrows(IllegalArgumentException.class, () -> CurvePlace.of(curve, 2, 0));
        assertThrows(IllegalArgumentException.class, () -> CurvePlace.of(curve, -1, 0));
    }
}
