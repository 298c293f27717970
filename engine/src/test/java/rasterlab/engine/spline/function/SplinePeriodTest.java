package rasterlab.engine.spline.function;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.math.BigDecimal;
import java.util.stream.Stream;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.SplineEnds;

/**
 * Places outside the knots of a periodic spline, as the references and as the methods fold them.
 */
class SplinePeriodTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("places")
    void placeComesToLieAt(double first, double last, double place, BigDecimal expected) {
        BigDecimal folded = problem(SplineEnds.periodic(), first, last).folded(place);
        assertEquals(0, expected.compareTo(folded), folded + " instead of " + expected);
        assertEquals(distance(first, expected), methodsDistance(first, last, place));
    }

    static Stream<Arguments> places() {
        var least = new BigDecimal(Double.MIN_VALUE);
        var seventh = new BigDecimal(7.1);
        return Stream.of(
                argumentSet("a period behind the last knot", 1, 4, 7, new BigDecimal(1)),
                argumentSet("many periods behind", 1, 4, 301, new BigDecimal(1)),
                argumentSet("a period before the first knot", 1, 4, -2, new BigDecimal(1)),
                argumentSet("many periods before", 1, 4, -299, new BigDecimal(1)),
                argumentSet("within a period behind", 1, 4, 6, new BigDecimal(3)),
                argumentSet("within a period before", 1, 4, -1, new BigDecimal(2)),
                argumentSet("knots below 0", -4, -1, 0, new BigDecimal(-3)),
                argumentSet("−0 before the knots", 1, 4, -0.0, new BigDecimal(3)),
                argumentSet(
                        "too near to the last knot for a double",
                        0,
                        1,
                        -Double.MIN_VALUE,
                        BigDecimal.ONE.subtract(least)),
                argumentSet(
                        "a place that is rounded while folding",
                        0,
                        7,
                        7.1,
                        seventh.subtract(new BigDecimal(7))),
                argumentSet(
                        "the largest double",
                        0,
                        3,
                        Double.MAX_VALUE,
                        new BigDecimal(Double.MAX_VALUE).remainder(new BigDecimal(3))));
    }

    @Property(tries = 2000, edgeCases = EdgeCasesMode.MIXIN)
    void methodsAndReferencesFoldAlike(
            @ForAll @Scale(12) @DoubleRange(min = -1e3, max = 1e3) double first,
            @ForAll @Scale(12) @DoubleRange(min = 1e-3, max = 1e3) double period,
            @ForAll @Scale(12) @DoubleRange(min = -1e9, max = 1e9) double place) {
        double last = first + period;
        SplineProblem problem = problem(SplineEnds.periodic(), first, last);
        if (problem.folds(place))
            assertEquals(
                    distance(first, problem.folded(place)), methodsDistance(first, last, place));
    }

    @ParameterizedTest(name = "{0} in [1, 4]: {1}")
    @CsvSource({
        "1, false",
        "4, false",
        "2, false",
        "0.9999999999999999, true",
        "4.000000000000001, true",
        "Infinity, true",
        "-Infinity, true",
        "NaN, false"
    })
    void onlyWhatLiesOutsideIsFolded(double place, boolean outside) {
        assertEquals(outside, problem(SplineEnds.periodic(), 1, 4).folds(place));
        assertFalse(problem(SplineEnds.natural(), 1, 4).folds(place), "without a period");
    }

    @ParameterizedTest(name = "{0}")
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void referencesRefuseAPlaceThatIsNotFinite(double place) {
        SplineProblem problem = problem(SplineEnds.periodic(), 1, 4, place);
        assertThrows(NumberFormatException.class, () -> problem.folded(place));
        assertThrows(NumberFormatException.class, () -> new ExactSpline(problem).values());
        assertThrows(NumberFormatException.class, () -> new ExactMonotone(problem).values());
    }

    @Test
    @DisplayName("a reference does not go on by whole periods")
    void referencesRepeatTheirValues() {
        var repeated =
                new SplineProblem(
                        new double[] {1, 2, 4},
                        new double[] {0, 1, 0},
                        SplineEnds.periodic(),
                        new double[] {1.5, 4.5, -1.5, 31.5, 4, -2},
                        false);
        for (double[] values :
                new double[][] {
                    new ExactSpline(repeated).values(), new ExactMonotone(repeated).values()
                }) {
            for (int i = 1; i < 4; i++) assertEquals(values[0], values[i], "place " + i);
            assertEquals(0, values[4]);
            assertEquals(0, values[5]);
        }
    }

    private static SplineProblem problem(
            SplineEnds ends, double first, double last, double... places) {
        return new SplineProblem(
                new double[] {first, last}, new double[] {0, 0}, ends, places, false);
    }

    /** The place within a straight piece: its distance from the first knot, rounded once. */
    private static double methodsDistance(double first, double last, double place) {
        var knots = new double[] {first, last};
        var line = new double[] {0, 1, 0, 0};
        double[] at = {place};
        return new PiecewiseCubic(knots, line, SplineEnds.periodic()).unchecked(at)[0];
    }

    private static double distance(double first, BigDecimal place) {
        return place.subtract(new BigDecimal(first)).doubleValue();
    }
}
