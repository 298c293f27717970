package rasterlab.engine.spline.function;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.study.Deviation;

/**
 * Checks the promises of a spline on random knots whose widths differ by up to a factor of a
 * thousand.
 */
class SplineFunctionPropertyTest {
    private static final SplineFunctionTopic TOPIC = new SplineFunctionTopic();
    private static final double CLOSE = 1e-9;

    @Property(tries = 400)
    void cubicPassesThroughItsPointsWithoutAJumpInSlopeOrBend(
            @ForAll @IntRange(min = 2, max = 40) int knots,
            @ForAll SplineEnds.Kind kind,
            @ForAll long seed) {
        SplineProblem p = problem(knots, kind, seed);
        double[] c = new CubicSpline().coefficients(p.x(), p.y(), p.ends());
        for (int i = 0; i + 1 < p.x().length; i++) {
            double h = p.x()[i + 1] - p.x()[i];
            double size = size(c, i, h);
            assertEquals(p.y()[i], c[4 * i], "knot " + i);
            assertEquals(p.y()[i + 1], value(c, i, h), CLOSE * size, "value at knot " + (i + 1));
            boolean last = i + 2 == p.x().length;
            if (last && kind != SplineEnds.Kind.PERIODIC) continue;
            int next = last ? 0 : i + 1;
            double both = Math.max(size, size(c, next, p.x()[next + 1] - p.x()[next]));
            assertEquals(c[4 * next + 1] * h, slope(c, i, h) * h, CLOSE * both, "slope " + i);
            double bend = 2 * c[4 * i + 2] + 6 * c[4 * i + 3] * h;
            assertEquals(2 * c[4 * next + 2] * h * h, bend * h * h, CLOSE * both, "bend " + i);
        }
    }

    @Property(tries = 400)
    void endsAreAsAsked(
            @ForAll @IntRange(min = 4, max = 40) int knots,
            @ForAll SplineEnds.Kind kind,
            @ForAll long seed) {
        SplineProblem p = problem(knots, kind, seed);
        double[] c = new CubicSpline().coefficients(p.x(), p.y(), p.ends());
        int last = knots - 2;
        double h = p.x()[last + 1] - p.x()[last];
        double size = size(c, last, h);
        switch (kind) {
            case SLOPES -> {
                assertEquals(p.ends().left(), c[1], CLOSE * Math.max(1, Math.abs(c[2])));
                assertEquals(p.ends().right() * h, slope(c, last, h) * h, CLOSE * size);
            }
            case NATURAL -> {
                assertEquals(0, c[2]);
                double bend = 2 * c[4 * last + 2] + 6 * c[4 * last + 3] * h;
                assertEquals(0, bend * h * h, CLOSE * size);
            }
            case NOT_A_KNOT -> {
                assertSamePiece(c, 0, 1, p.x()[1] - p.x()[0]);
                assertSamePiece(c, last - 1, last, h);
            }
            case PERIODIC -> assertEquals(c[1] * h, slope(c, last, h) * h, CLOSE * size);
        }
    }

    private static void assertSamePiece(double[] c, int i, int next, double h) {
        double cubed = h * h * h;
        double size = Math.max(size(c, i, h), size(c, next, h));
        assertEquals(c[4 * i + 3] * cubed, c[4 * next + 3] * cubed, CLOSE * size);
    }

    @Property(tries = 400)
    void monotoneNeverLeavesTheValuesOfItsKnots(
            @ForAll @IntRange(min = 2, max = 40) int knots,
            @ForAll SplineEnds.Kind kind,
            @ForAll long seed) {
        SplineProblem p = problem(knots, kind, seed);
        double[] c = new MonotoneSpline().coefficients(p.x(), p.y(), p.ends());
        for (int i = 0; i + 1 < p.x().length; i++) {
            double low = Math.min(p.y()[i], p.y()[i + 1]);
            double high = Math.max(p.y()[i], p.y()[i + 1]);
            double h = p.x()[i + 1] - p.x()[i];
            double rounding = 1e-14 * size(c, i, h);
            for (int k = 0; k <= 64; k++) {
                double value = value(c, i, h * k / 64);
                assertTrue(value >= low - rounding && value <= high + rounding, "piece " + i);
            }
        }
    }

    @Property(tries = 150)
    void bothMethodsAgreeWithTheirReferences(
            @ForAll @IntRange(min = 2, max = 30) int knots,
            @ForAll SplineEnds.Kind kind,
            @ForAll long seed) {
        SplineProblem p = problem(knots, kind, seed);
        SplineValues exact = TOPIC.exact(p, 1_000);
        for (var method : RightSplines.all()) {
            SplineFunction function = method.implementation();
            Deviation deviation = TOPIC.compare(p, exact, TOPIC.record(function, p, 1_000));
            assertTrue(TOPIC.correct(deviation), method.name() + " " + deviation);
        }
    }

    private static SplineProblem problem(int knots, SplineEnds.Kind kind, long seed) {
        var random = new Random(seed);
        var x = new double[knots];
        var y = new double[knots];
        var at = new double[3 * knots];
        x[0] = random.nextInt(-5, 5);
        for (int i = 0; i < knots; i++) {
            if (i > 0) x[i] = x[i - 1] + Math.pow(10, random.nextInt(-3, 1));
            y[i] = random.nextBoolean() ? random.nextInt(-9, 9) : random.nextGaussian();
        }
        // Beyond the knots by up to one piece: farther out an end piece's rounding grows as the
        // cube.
        double before = x[0] - (x[1] - x[0]);
        double behind = x[knots - 1] + (x[knots - 1] - x[knots - 2]);
        for (int i = 0; i < at.length; i++)
            at[i] = before + (behind - before) * random.nextDouble();
        if (kind == SplineEnds.Kind.PERIODIC) y[knots - 1] = y[0];
        boolean slopes = kind == SplineEnds.Kind.SLOPES;
        double left = slopes ? random.nextInt(-9, 9) : 0;
        double right = slopes ? random.nextInt(-9, 9) : 0;
        return new SplineProblem(x, y, new SplineEnds(kind, left, right), at, false);
    }

    private static double value(double[] c, int i, double s) {
        return c[4 * i] + s * (c[4 * i + 1] + s * (c[4 * i + 2] + s * c[4 * i + 3]));
    }

    private static double slope(double[] c, int i, double s) {
        return c[4 * i + 1] + s * (2 * c[4 * i + 2] + s * 3 * c[4 * i + 3]);
    }

    /** The unit by which rounding in piece i is measured. */
    private static double size(double[] c, int i, double h) {
        return Math.abs(c[4 * i])
                + h
                        * (Math.abs(c[4 * i + 1])
                                + h * (Math.abs(c[4 * i + 2]) + h * Math.abs(c[4 * i + 3])));
    }
}
