package rasterlab.engine.spline.function;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.contract.SplineEnds;

class OvershootTest {
    private static final double[] X = {0, 1, 2, 3, 4, 5, 6, 7};
    private static final double[] STEP = {0, 0, 0, 0, 1, 1, 1, 1};

    @Test
    void cubicSwingsAroundAStepAndMonotoneDoesNot() {
        List<Overshoot> cubic = of(X, STEP, new CubicSpline().coefficients(X, STEP, natural()));
        assertTrue(cubic.stream().anyMatch(each -> each.y() > 1), "nothing above");
        assertTrue(cubic.stream().anyMatch(each -> each.y() < 0), "nothing below");
        assertTrue(cubic.stream().noneMatch(each -> each.piece() == 3), "the step itself");
        assertEquals(List.of(), of(X, STEP, new MonotoneSpline().coefficients(X, STEP, natural())));
    }

    /** s·(1 − s) on [0, 1]: the parabola's top is ¼ at ½. */
    @Test
    void farthestPlaceOfAParabolaIsItsTop() {
        List<Overshoot> top =
                of(new double[] {2, 3}, new double[] {5, 5}, new double[] {5, 1, -1, 0});
        assertEquals(1, top.size());
        assertEquals(2.5, top.get(0).x());
        assertEquals(5.25, top.get(0).y());
        assertEquals(0.25, top.get(0).by());
    }

    /** s·(s − ½)·(s − 1): above, then below. */
    @Test
    void pieceMayLeaveOnBothSides() {
        List<Overshoot> both =
                of(new double[] {0, 1}, new double[] {0, 0}, new double[] {0, 0.5, -1.5, 1});
        assertEquals(2, both.size());
        assertTrue(both.get(0).y() > 0 && both.get(1).y() < 0, both.toString());
        assertEquals(both.get(0).by(), both.get(1).by(), 1e-15);
    }

    @Test
    void linesAndConstantsStayInside() {
        double[] x = {0, 1, 2};
        assertEquals(
                List.of(), of(x, new double[] {0, 3, 3}, new double[] {0, 3, 0, 0, 3, 0, 0, 0}));
    }

    @Test
    void extremesOutsideThePieceDoNotCount() {
        double[] one = {0, 1};
        assertEquals(List.of(), of(one, new double[] {0, 3}, new double[] {0, 4, -1, 0}));
        assertEquals(List.of(), of(one, new double[] {0, 5}, new double[] {0, 4, 1, 0}));
    }

    private static List<Overshoot> of(double[] x, double[] y, double[] coefficients) {
        return Overshoot.all(x, y, coefficients);
    }

    private static SplineEnds natural() {
        return SplineEnds.natural();
    }
}
