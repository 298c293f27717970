package rasterlab.engine.spline.function;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.SplineEnds;

/** Splines known by heart, and points that no method may take. */
class SplineFunctionTest {
    private static final SplineEnds NATURAL = SplineEnds.natural();

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("known")
    void cubicHasTheseCoefficients(double[] x, double[] y, SplineEnds ends, double[] expected) {
        assertArrayEquals(expected, new CubicSpline().coefficients(x, y, ends), 1e-14);
    }

    static Stream<Arguments> known() {
        return Stream.of(
                argumentSet(
                        "chapter 8: the last piece forgets its own knot",
                        of(0, 1, 2),
                        of(0, 1, 0),
                        NATURAL,
                        of(0, 1.5, 0, -0.5, 1, 0, -1.5, 0.5)),
                argumentSet(
                        "chapter 8: given slopes are swapped",
                        of(0, 2),
                        of(1, 3),
                        SplineEnds.slopes(0, 6),
                        of(1, 0, -1.5, 1)),
                argumentSet(
                        "two natural knots are no line",
                        of(0, 2),
                        of(1, 3),
                        NATURAL,
                        of(1, 1, 0, 0)),
                argumentSet(
                        "two not-a-knot knots are no line",
                        of(0, 2),
                        of(1, 3),
                        SplineEnds.notAKnot(),
                        of(1, 1, 0, 0)),
                argumentSet(
                        "two periodic knots are no constant",
                        of(0, 2),
                        of(3, 3),
                        SplineEnds.periodic(),
                        of(3, 0, 0, 0)),
                argumentSet(
                        "three not-a-knot knots are no parabola",
                        of(0, 1, 3),
                        of(0, 1, 9),
                        SplineEnds.notAKnot(),
                        of(0, 0, 1, 0, 1, 2, 1, 0)),
                argumentSet(
                        "four not-a-knot knots are no cubic",
                        of(-1, 0, 1, 3),
                        of(-1, 0, 1, 27),
                        SplineEnds.notAKnot(),
                        of(-1, 3, -3, 1, 0, 0, 0, 1, 1, 3, 3, 1)),
                argumentSet(
                        "three periodic knots lose their corner rows",
                        of(0, 1, 2),
                        of(0, 1, 0),
                        SplineEnds.periodic(),
                        of(0, 0, 3, -2, 1, 0, -3, 2)));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("refused")
    void refusesWithPlaceAndValue(double[] x, double[] y, SplineEnds ends, String message) {
        for (var method : RightSplines.all()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> method.implementation().coefficients(x, y, ends));
            assertEquals(message, refusal.getMessage(), method.name());
        }
    }

    static Stream<Arguments> refused() {
        double nan = Double.NaN;
        double infinite = Double.POSITIVE_INFINITY;
        return Stream.of(
                argumentSet("no knot", of(), of(), NATURAL, "x: needs at least 2 knots, got 0"),
                argumentSet("one knot", of(1), of(1), NATURAL, "x: needs at least 2 knots, got 1"),
                argumentSet(
                        "a value is missing",
                        of(1, 2, 3),
                        of(1, 2),
                        NATURAL,
                        "y: needs one value for each of 3 knots, got 2"),
                argumentSet(
                        "equal knots",
                        of(0, 1, 1, 2),
                        of(0, 1, 2, 3),
                        NATURAL,
                        "x[2] must be above x[1] = 1.0, got 1.0"),
                argumentSet(
                        "0 after −0",
                        of(-0.0, 0.0),
                        of(0, 1),
                        NATURAL,
                        "x[1] must be above x[0] = -0.0, got 0.0"),
                argumentSet(
                        "falling knots",
                        of(0, 2, 1),
                        of(0, 1, 2),
                        NATURAL,
                        "x[2] must be above x[1] = 2.0, got 1.0"),
                argumentSet(
                        "knot is NaN",
                        of(0, nan, 1),
                        of(0, 1, 2),
                        NATURAL,
                        "x[1] must be finite, got NaN"),
                argumentSet(
                        "knot is infinite",
                        of(0, infinite),
                        of(0, 1),
                        NATURAL,
                        "x[1] must be finite, got Infinity"),
                argumentSet(
                        "value is NaN",
                        of(0, 1),
                        of(0, nan),
                        NATURAL,
                        "y[1] must be from -1.0E75 to 1.0E75, got NaN"),
                argumentSet(
                        "value at the doubles' limit",
                        of(0, 1),
                        of(Double.MAX_VALUE, 0),
                        NATURAL,
                        "y[0] must be from -1.0E75 to 1.0E75, got 1.7976931348623157E308"),
                argumentSet(
                        "all values vanish in the coefficients",
                        of(0, 1),
                        of(0, Double.MIN_VALUE),
                        NATURAL,
                        "y: the largest |y| must be 0 or at least 1.0E-75, got 4.9E-324"),
                argumentSet(
                        "width overflows",
                        of(-Double.MAX_VALUE, Double.MAX_VALUE),
                        of(0, 1),
                        NATURAL,
                        "x[1] − x[0] must be from 1.0E-75 to 1.0E75, got Infinity"),
                argumentSet(
                        "width underflows",
                        of(0, Double.MIN_VALUE),
                        of(0, 1),
                        NATURAL,
                        "x[1] − x[0] must be from 1.0E-75 to 1.0E75, got 4.9E-324"),
                argumentSet(
                        "steep end",
                        of(0, 1),
                        of(0, 1),
                        SplineEnds.slopes(1e200, 0),
                        "ends: left slope must be 0 or in ±1.0E-150..±1.0E150, got 1.0E200"),
                argumentSet(
                        "period does not close",
                        of(0, 1, 2),
                        of(0, 1, 0.5),
                        SplineEnds.periodic(),
                        "y[2] must equal y[0] = 0.0 where the ends are periodic, got 0.5"));
    }

    @Test
    void endSlopesMustBeNumbers() {
        assertThrows(IllegalArgumentException.class, () -> SplineEnds.slopes(0, Double.NaN));
        assertThrows(
                IllegalArgumentException.class,
                () -> new SplineEnds(SplineEnds.Kind.NATURAL, 1, 0));
    }

    @Test
    void aMillionKnotsTakeOneWalk() {
        var x = new double[1_000_000];
        Arrays.setAll(x, i -> i);
        double[] y = Arrays.stream(x).map(v -> 3 - 2 * v).toArray();
        for (var method : RightSplines.all())
            for (var ends : new SplineEnds[] {NATURAL, SplineEnds.notAKnot()}) {
                double[] line = method.implementation().coefficients(x, y, ends);
                for (int i = 0; i < line.length; i += 4) {
                    assertEquals(-2, line[i + 1], 1e-9, method.name());
                    assertEquals(0, line[i + 2], 1e-9, method.name());
                }
            }
    }

    @Test
    void outsideTheKnotsTheEndPiecesGoOn() {
        double[] x = of(0, 1, 3);
        double[] parabola = new CubicSpline().coefficients(x, of(0, 1, 9), SplineEnds.notAKnot());
        var function = new PiecewiseCubic(x, parabola, SplineEnds.notAKnot());
        assertArrayEquals(of(4, 16, 100), function.at(of(-2, 4, 10)), 1e-12);
    }

    @Test
    void outsideTheKnotsThePeriodGoesOn() {
        double[] x = of(0, 1, 2);
        double[] wave = new CubicSpline().coefficients(x, of(0, 1, 0), SplineEnds.periodic());
        var function = new PiecewiseCubic(x, wave, SplineEnds.periodic());
        double[] inside = function.at(of(0.5, 1.25, 0, 1));
        assertArrayEquals(inside, function.at(of(-1.5, 5.25, 2, -1)), 1e-15);
    }

    /**
     * The period 9 + 2⁻⁵⁰ does not fit in a double, and the tooth is steep enough to show what it
     * lacks.
     */
    @Test
    void thePeriodGoesOnWithoutRoundingThePlace() {
        double[] x = of(-Math.pow(2, -50), 8, 8 + Math.pow(2, -33), 9);
        var tooth = new double[12];
        tooth[5] = Math.pow(2, 34);
        var function = new PiecewiseCubic(x, tooth, SplineEnds.periodic());
        double half = Math.pow(2, -34);
        double[] expected = of(1, 1 - Math.pow(2, -16), 1 + Math.pow(2, -16));
        assertArrayEquals(expected, function.at(of(8 + half, 17 + half, -1 + half)));
    }

    @ParameterizedTest(name = "knots {0}, {1}")
    @CsvSource({"1, 1", "2, 1", "0, Infinity", "NaN, 1"})
    void knotsWithoutAPeriodAreNotFolded(double first, double last) {
        var function = new PiecewiseCubic(of(first, last), of(0, 1, 0, 0), SplineEnds.periodic());
        assertEquals(5 - first, function.unchecked(of(5))[0]);
    }

    @Test
    void placesMustBeNumbersAndReachable() {
        var function = new PiecewiseCubic(of(0, 1), of(0, 1, 1, 1), NATURAL);
        var nan =
                assertThrows(IllegalArgumentException.class, () -> function.at(of(0, Double.NaN)));
        assertEquals("at[1] must be finite, got NaN", nan.getMessage());
        var far = assertThrows(IllegalArgumentException.class, () -> function.at(of(1e200)));
        assertEquals(
                "at[0] = 1.0E200: the value there is beyond the doubles' range", far.getMessage());
    }

    private static double[] of(double... numbers) {
        return numbers;
    }
}
