package rasterlab.engine.spline.exact;

import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.study.Slip;

/** Curves whose weights, points or derivatives are mistaken. */
public final class CurveSlips {
    private CurveSlips() {}

    public static List<Slip<CurveTracer>> of(CurveTracer right) {
        return Stream.of(ofBezier(right), ofHermite(right)).flatMap(List::stream).toList();
    }

    private static List<Slip<CurveTracer>> ofBezier(CurveTracer right) {
        return List.of(
                weighted(
                        "binomials-left-out",
                        right,
                        (n, i, t) -> power(t, i) * power(1 - t, n - i)),
                weighted(
                        "last-point-left-out",
                        right,
                        (n, i, t) -> i == n ? 0 : CurveSlips.bernstein(n, i, t)),
                weighted(
                        "first-point-left-out",
                        right,
                        (n, i, t) -> i == 0 ? 0 : CurveSlips.bernstein(n, i, t)),
                weighted(
                        "degree-one-too-small",
                        right,
                        (n, i, t) -> CurveSlips.bernstein(n, i, t) / (1 - t)),
                Slip.of("points-straight-joined", at(right, CurveSlips::alongThePoints)),
                Slip.of(
                        "four-points-only",
                        at(
                                right,
                                (curve, t, out) ->
                                        right.at(
                                                curve.x().length > 4 ? first(curve, 4) : curve,
                                                t,
                                                out))),
                Slip.of(
                        "t-in-float",
                        at(
                                right,
                                (curve, t, out) ->
                                        right.at(
                                                curve,
                                                Arrays.stream(t).map(one -> (float) one).toArray(),
                                                out))),
                Slip.of("points-overwritten", at(right, CurveSlips::inPlace)));
    }

    private static List<Slip<CurveTracer>> ofHermite(CurveTracer right) {
        return List.of(
                hermite(
                        "derivatives-after-their-points",
                        right,
                        a -> new double[] {a[0], a[2], a[1], a[3]}),
                hermite("derivatives-first", right, a -> new double[] {a[2], a[3], a[0], a[1]}),
                hermite("derivatives-ignored", right, a -> new double[] {a[0], a[1], 0, 0}),
                hermite(
                        "tips-for-derivatives",
                        right,
                        a -> new double[] {a[0], a[1], a[2] - a[0], a[3] - a[1]}),
                hermite(
                        "tips-inwards",
                        right,
                        a -> new double[] {a[0], a[1], a[2] - a[0], a[1] - a[3]}),
                hermite(
                        "halves-for-thirds",
                        right,
                        a -> new double[] {a[0], a[1], 1.5 * a[2], 1.5 * a[3]}),
                hermite("ends-swapped", right, a -> new double[] {a[1], a[0], a[2], a[3]}),
                hermite(
                        "both-derivatives-reversed",
                        right,
                        a -> new double[] {a[0], a[1], -a[2], -a[3]}));
    }

    private interface At {
        void at(Curve curve, double[] t, CurvePoints out);
    }

    private static CurveTracer at(CurveTracer right, At at) {
        return new CurveTracer() {
            @Override
            public void at(Curve curve, double[] t, CurvePoints out) {
                at.at(curve, t, out);
            }

            @Override
            public void flatten(Curve curve, double flatness, CurvePoints out) {
                right.flatten(curve, flatness, out);
            }
        };
    }

    private interface Weight {
        double of(int n, int i, double t);
    }

    /** The sum of the control points by other weights; other curves are right. */
    private static Slip<CurveTracer> weighted(String name, CurveTracer right, Weight weight) {
        return Slip.of(
                name,
                at(
                        right,
                        (curve, t, out) -> {
                            if (curve.kind() != Curve.Kind.BEZIER) right.at(curve, t, out);
                            else
                                for (double one : t)
                                    out.point(
                                            sum(curve.x(), one, weight),
                                            sum(curve.y(), one, weight));
                        }));
    }

    private static double sum(double[] points, double t, Weight weight) {
        double sum = 0;
        for (int i = 0; i < points.length; i++)
            sum += weight.of(points.length - 1, i, t) * points[i];
        return sum;
    }

    private static double bernstein(int n, int i, double t) {
        double choose = 1;
        for (int k = 1; k <= i; k++) choose = choose * (n - k + 1) / k;
        return choose * power(t, i) * power(1 - t, n - i);
    }

    private static double power(double base, int exponent) {
        return Math.pow(base, exponent);
    }

    private static Curve first(Curve curve, int points) {
        return new Curve(
                curve.kind(), Arrays.copyOf(curve.x(), points), Arrays.copyOf(curve.y(), points));
    }

    /** Takes the point at t of the control polygon, with as much of t for each side. */
    private static void alongThePoints(Curve curve, double[] t, CurvePoints out) {
        int sides = curve.x().length - 1;
        for (double one : t) {
            int side = Math.max(0, Math.min(sides - 1, (int) (one * sides)));
            int next = Math.min(side + 1, sides);
            double share = one * sides - side;
            out.point(
                    (1 - share) * curve.x()[side] + share * curve.x()[next],
                    (1 - share) * curve.y()[side] + share * curve.y()[next]);
        }
    }

    /** De Casteljau's rows take the place of the control points, for the next t as well. */
    private static void inPlace(Curve curve, double[] t, CurvePoints out) {
        double[] x = curve.x().clone();
        double[] y = curve.y().clone();
        for (double one : t) {
            for (int row = x.length - 1; row > 0; row--)
                for (int i = 0; i < row; i++) {
                    x[i] = (1 - one) * x[i] + one * x[i + 1];
                    y[i] = (1 - one) * y[i] + one * y[i + 1];
                }
            out.point(x[0], y[0]);
        }
    }

    private static Slip<CurveTracer> hermite(
            String name, CurveTracer right, UnaryOperator<double[]> change) {
        return Slip.of(
                name,
                at(
                        right,
                        (curve, t, out) ->
                                right.at(
                                        curve.kind() == Curve.Kind.HERMITE
                                                ? new Curve(
                                                        curve.kind(),
                                                        change.apply(curve.x()),
                                                        change.apply(curve.y()))
                                                : curve,
                                        t,
                                        out)));
    }
}
