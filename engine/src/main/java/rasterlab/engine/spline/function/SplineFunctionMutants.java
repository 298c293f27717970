package rasterlab.engine.spline.function;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.study.Mutant;

/** Splines with one mistake. */
final class SplineFunctionMutants {
    private static final SplineFunction RIGHT = new CubicSpline();

    private SplineFunctionMutants() {}

    static List<Mutant<SplineFunction>> all() {
        return List.of(
                new Mutant<>("promised-shape-swings", "overshoot", new SwingingShape()),
                new Mutant<>(
                        "equal-widths",
                        "uneven-knots",
                        (x, y, ends) -> RIGHT.coefficients(even(x), y, ends)),
                new Mutant<>("end-slopes-ignored", "two-knots", natural(SplineEnds.Kind.SLOPES)),
                new Mutant<>(
                        "not-a-knot-is-natural",
                        "three-knots",
                        natural(SplineEnds.Kind.NOT_A_KNOT)),
                new Mutant<>("periodic-is-natural", "periodic", natural(SplineEnds.Kind.PERIODIC)),
                new Mutant<>(
                        "knots-sorted",
                        "unordered-knots",
                        (x, y, ends) -> {
                            double[] sorted = x.clone();
                            Arrays.sort(sorted);
                            return RIGHT.coefficients(sorted, y, ends);
                        }),
                new Mutant<>(
                        "knots-in-float",
                        "far-from-zero",
                        (x, y, ends) -> RIGHT.coefficients(inFloat(x), inFloat(y), ends)),
                new Mutant<>("powers-of-x", "three-knots", SplineFunctionMutants::ofX),
                new Mutant<>("highest-power-first", "two-knots", SplineFunctionMutants::backwards),
                new Mutant<>(
                        "natural-is-level",
                        "overshoot",
                        taking(SplineEnds.Kind.NATURAL, SplineEnds.slopes(0, 0))),
                new Mutant<>(
                        "second-derivative-for-c",
                        "three-knots",
                        (x, y, ends) -> times(RIGHT.coefficients(x, y, ends), 2, 2)),
                new Mutant<>("straight-pieces", "three-knots", SplineFunctionMutants::straight),
                new Mutant<>("half-the-bend", "overshoot", SplineFunctionMutants::halfBent),
                new Mutant<>(
                        "end-slopes-swapped",
                        "two-knots",
                        (x, y, ends) ->
                                RIGHT.coefficients(
                                        x,
                                        y,
                                        ends.kind() == SplineEnds.Kind.SLOPES
                                                ? SplineEnds.slopes(ends.right(), ends.left())
                                                : ends)));
    }

    /** Takes ends of that kind for natural ones. */
    private static SplineFunction natural(SplineEnds.Kind asked) {
        return taking(asked, SplineEnds.natural());
    }

    private static SplineFunction taking(SplineEnds.Kind asked, SplineEnds taken) {
        return (x, y, ends) -> RIGHT.coefficients(x, y, ends.kind() == asked ? taken : ends);
    }

    /** The coefficients of 1, x, x², x³ where those of s = x − x[i] are asked for. */
    private static double[] ofX(double[] x, double[] y, SplineEnds ends) {
        double[] all = RIGHT.coefficients(x, y, ends);
        for (int i = 0; i < all.length; i += 4) {
            double knot = x[i / 4];
            double b = all[i + 1];
            double c = all[i + 2];
            double d = all[i + 3];
            all[i] -= knot * (b - knot * (c - knot * d));
            all[i + 1] = b - knot * (2 * c - 3 * d * knot);
            all[i + 2] = c - 3 * d * knot;
        }
        return all;
    }

    private static double[] backwards(double[] x, double[] y, SplineEnds ends) {
        double[] right = RIGHT.coefficients(x, y, ends);
        var backwards = new double[right.length];
        for (int i = 0; i < right.length; i++) backwards[i] = right[i / 4 * 4 + 3 - i % 4];
        return backwards;
    }

    /** Knots at equal distances where all are finite and in order. */
    private static double[] even(double[] x) {
        var even = new double[x.length];
        int last = x.length - 1;
        for (int i = 0; i <= last; i++) {
            if (i > 0 && !(x[i] > x[i - 1])) return x;
            even[i] = i == last ? x[last] : x[0] + (x[last] - x[0]) * i / last;
        }
        return even;
    }

    private static double[] inFloat(double[] values) {
        return Arrays.stream(values).map(value -> (float) value).toArray();
    }

    private static final class SwingingShape implements SplineFunction {
        @Override
        public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
            SplineFunction shown = steep(y) ? RIGHT : new MonotoneSpline();
            return shown.coefficients(x, y, ends);
        }

        /** Whether the values have a step after level ones. */
        private static boolean steep(double[] y) {
            return y.length > 2 && y[0] == y[1] && y[0] != y[y.length - 1];
        }

        @Override
        public Promise promise() {
            return Promise.SHAPE;
        }
    }

    private static double[] times(double[] all, int power, double factor) {
        for (int i = power; i < all.length; i += 4) all[i] *= factor;
        return all;
    }

    private static double[] straight(double[] x, double[] y, SplineEnds ends) {
        double[] all = RIGHT.coefficients(x, y, ends);
        for (int i = 0; i < all.length; i += 4) {
            all[i + 1] = (y[i / 4 + 1] - y[i / 4]) / (x[i / 4 + 1] - x[i / 4]);
            all[i + 2] = 0;
            all[i + 3] = 0;
        }
        return all;
    }

    /** A natural spline from 3, not 6, times the differences of the slopes: M is half as large. */
    private static double[] halfBent(double[] x, double[] y, SplineEnds ends) {
        double[] all = RIGHT.coefficients(x, y, ends);
        if (ends.kind() != SplineEnds.Kind.NATURAL) return all;
        for (int i = 0; i < all.length; i += 4) {
            double slope = (y[i / 4 + 1] - y[i / 4]) / (x[i / 4 + 1] - x[i / 4]);
            all[i + 1] = (all[i + 1] + slope) / 2;
            all[i + 2] /= 2;
            all[i + 3] /= 2;
        }
        return all;
    }
}
