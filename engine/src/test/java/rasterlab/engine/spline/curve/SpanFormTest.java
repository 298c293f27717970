package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.contract.Curve;
import rasterlab.contract.Curve.Kind;

class SpanFormTest {
    private static final double[] X = {10, 60, 180, 250};
    private static final double[] Y = {200, 20, 40, 190};

    @ParameterizedTest(name = "a factor of {0} is wrong")
    @EnumSource(Kind.class)
    void allThreeProductsAreThePoint(Kind kind) {
        var curve = new Curve(kind, X, Y);
        SpanForm form = SpanForm.at(curve, 0.3);
        CurvePlace place = CurvePlace.at(curve, 0.3);
        for (int axis = 0; axis < 2; axis++) {
            double byWeights = 0;
            double byPowers = 0;
            for (int i = 0; i < 4; i++) {
                byWeights += form.weights()[i] * form.geometry()[i][axis];
                byPowers += form.powers()[i] * form.coefficients()[i][axis];
            }
            double right = axis == 0 ? place.x() : place.y();
            assertEquals(right, byWeights, 1e-9, "T·M times G");
            assertEquals(right, byPowers, 1e-9, "T times C");
        }
        assertArrayEquals(form.weights(), form.weightsAt(0.3), 1e-12);
    }

    @Test
    void spanIsThatOfT() {
        double[] x = {0, 10, 20, 30, 40, 50};
        SpanForm form = SpanForm.at(new Curve(Kind.B_SPLINE, x, x), 0.5);
        assertEquals(1, form.span());
        assertEquals(0.5, form.u());
        assertArrayEquals(new double[] {0.125, 0.25, 0.5, 1}, form.powers());
        assertArrayEquals(new double[] {10, 10}, form.geometry()[0]);
        assertEquals(6, form.divisor());
    }

    @Test
    void highDegreesAreRefusedAsByTheMatrixMethod() {
        var curve = new Curve(Kind.BEZIER, new double[12], new double[12]);
        assertThrows(IllegalArgumentException.class, () -> SpanForm.at(curve, 0.5));
        assertThrows(
                IllegalArgumentException.class,
                () -> SpanForm.at(new Curve(Kind.BEZIER, X, Y), 1.5));
    }
}
