package rasterlab.engine.spline.function;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.study.Slip;

/** Splines whose coefficients stand in other places or are of other derivatives. */
final class SplineFunctionSlips {
    private SplineFunctionSlips() {}

    static List<Slip<SplineFunction>> of(SplineFunction right) {
        return List.of(
                changed("b-and-c-exchanged", right, (x, y, all) -> swapped(all, 1, 2)),
                changed("c-and-d-exchanged", right, (x, y, all) -> swapped(all, 2, 3)),
                changed("third-derivative-for-d", right, (x, y, all) -> scaled(all, 1, 1, 6)),
                changed("derivatives-for-c-and-d", right, (x, y, all) -> scaled(all, 1, 2, 6)),
                changed("coefficient-after-coefficient", right, (x, y, all) -> byKind(all)),
                changed("value-on-the-right-for-a", right, SplineFunctionSlips::fromTheRight),
                changed("d-left-out", right, (x, y, all) -> scaled(all, 1, 1, 0)),
                changed("c-left-out", right, (x, y, all) -> scaled(all, 1, 0, 1)),
                changed("c-and-d-left-out", right, (x, y, all) -> scaled(all, 1, 0, 0)),
                changed(
                        "last-piece-left-out",
                        right,
                        (x, y, all) -> Arrays.copyOf(all, Math.max(0, all.length - 4))),
                Slip.of(
                        "end-slopes-level",
                        (x, y, ends) ->
                                right.coefficients(
                                        x,
                                        y,
                                        ends.kind() == SplineEnds.Kind.SLOPES
                                                ? SplineEnds.slopes(0, 0)
                                                : ends)),
                Slip.of(
                        "one-end-slope-for-both",
                        (x, y, ends) -> right.coefficients(x, y, bothOf(ends, ends.left())),
                        (x, y, ends) -> right.coefficients(x, y, bothOf(ends, ends.right()))));
    }

    private interface Changed {
        double[] of(double[] x, double[] y, double[] coefficients);
    }

    private static Slip<SplineFunction> changed(
            String name, SplineFunction right, Changed changed) {
        return Slip.of(
                name, (x, y, ends) -> changed.of(x, y, right.coefficients(x, y, ends).clone()));
    }

    private static SplineEnds bothOf(SplineEnds ends, double slope) {
        return ends.kind() == SplineEnds.Kind.SLOPES ? SplineEnds.slopes(slope, slope) : ends;
    }

    private static double[] swapped(double[] all, int one, int other) {
        for (int i = 0; i < all.length; i += 4) {
            double kept = all[i + one];
            all[i + one] = all[i + other];
            all[i + other] = kept;
        }
        return all;
    }

    private static double[] scaled(double[] all, double b, double c, double d) {
        for (int i = 0; i < all.length; i += 4) {
            all[i + 1] *= b;
            all[i + 2] *= c;
            all[i + 3] *= d;
        }
        return all;
    }

    /** All a, then all b, all c and all d. */
    private static double[] byKind(double[] all) {
        double[] changed = new double[all.length];
        int pieces = all.length / 4;
        for (int i = 0; i < all.length; i++) changed[i] = all[i % pieces * 4 + i / pieces];
        return changed;
    }

    private static double[] fromTheRight(double[] x, double[] y, double[] all) {
        for (int i = 0; i < all.length; i += 4) all[i] = y[i / 4 + 1];
        return all;
    }
}
