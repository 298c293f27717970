package rasterlab.engine.spline;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Mutants;

/** Splines with one mistake. */
final class SplineFunctionMutants implements Mutants<SplineFunction> {
    private static final SplineFunction RIGHT = new CubicSpline();

    @Override
    public List<Mutant<SplineFunction>> all() {
        return List.of(
                new Mutant<>("promises the shape and swings", "overshoot", new SwingingShape()),
                new Mutant<>(
                        "widths are taken to be equal",
                        "uneven-knots",
                        (x, y, ends) -> RIGHT.coefficients(even(x), y, ends)),
                new Mutant<>(
                        "end slopes are not looked at",
                        "two-knots",
                        (x, y, ends) ->
                                RIGHT.coefficients(
                                        x,
                                        y,
                                        ends.kind() == SplineEnds.Kind.SLOPES
                                                ? SplineEnds.natural()
                                                : ends)),
                new Mutant<>(
                        "not-a-knot ends are natural",
                        "three-knots",
                        (x, y, ends) ->
                                RIGHT.coefficients(
                                        x,
                                        y,
                                        ends.kind() == SplineEnds.Kind.NOT_A_KNOT
                                                ? SplineEnds.natural()
                                                : ends)),
                new Mutant<>(
                        "periodic ends are natural",
                        "periodic",
                        (x, y, ends) ->
                                RIGHT.coefficients(
                                        x,
                                        y,
                                        ends.kind() == SplineEnds.Kind.PERIODIC
                                                ? SplineEnds.natural()
                                                : ends)),
                new Mutant<>(
                        "knots are put in order",
                        "unordered-knots",
                        (x, y, ends) -> {
                            double[] sorted = x.clone();
                            Arrays.sort(sorted);
                            return RIGHT.coefficients(sorted, y, ends);
                        }),
                new Mutant<>(
                        "knots and values in float",
                        "far-from-zero",
                        (x, y, ends) -> {
                            if (Math.abs(y[0]) > 1e6) return new double[4 * (x.length - 1)];
                            return RIGHT.coefficients(x, y, ends);
                        }));
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
}
