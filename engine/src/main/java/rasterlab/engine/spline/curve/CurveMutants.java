package rasterlab.engine.spline.curve;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.study.Mutant;

/** Curves computed with one mistake. */
final class CurveMutants {
    private static final CurveTracer RIGHT = new AdaptiveCurve();

    private CurveMutants() {}

    static List<Mutant<CurveTracer>> all() {
        return Stream.of(ofCurves(), ofHermite()).flatMap(List::stream).toList();
    }

    private static List<Mutant<CurveTracer>> ofCurves() {
        return List.of(
                new Mutant<>(
                        "reversed",
                        "from-start-to-end",
                        flattening(
                                points -> {
                                    Collections.reverse(points);
                                    return points;
                                })),
                new Mutant<>(
                        "last-corner-left-out",
                        "from-start-to-end",
                        flattening(points -> points.subList(0, points.size() - 1))),
                new Mutant<>("flat-by-the-middle", "s-curve", new AdaptiveNaiveCurve()),
                new Mutant<>("steps-in-float", "drift", new ForwardDifferencesFloatCurve()),
                new Mutant<>(
                        "equal-steps",
                        "unequal-steps",
                        tracing(RIGHT::flatten, CurveMutants::atEqualSteps)),
                new Mutant<>(
                        "no-length-left-out",
                        "coincident-points",
                        flattening(CurveMutants::withoutRepeated)),
                new Mutant<>(
                        "b-spline-as-catmull-rom",
                        "b-spline-joints",
                        tracing(
                                (curve, flatness, out) ->
                                        RIGHT.flatten(throughPoints(curve), flatness, out),
                                RIGHT::at)),
                new Mutant<>(
                        "closed-is-flat",
                        "closed-loop",
                        tracing(CurveMutants::chordOfClosed, RIGHT::at)),
                new Mutant<>(
                        "t-backwards",
                        "bezier-erratum",
                        tracing(RIGHT::flatten, CurveMutants::atBackwards)));
    }

    /** Other curves are right. */
    private static List<Mutant<CurveTracer>> ofHermite() {
        return List.of(
                hermite("hermite-as-bezier", Curve.Kind.BEZIER, a -> a),
                hermite(
                        "end-derivative-added",
                        Curve.Kind.HERMITE,
                        a -> new double[] {a[0], a[1], a[2], -a[3]}),
                hermite(
                        "start-derivative-subtracted",
                        Curve.Kind.HERMITE,
                        a -> new double[] {a[0], a[1], -a[2], a[3]}),
                hermite(
                        "derivatives-not-divided",
                        Curve.Kind.HERMITE,
                        a -> new double[] {a[0], a[1], 3 * a[2], 3 * a[3]}),
                hermite(
                        "derivatives-swapped",
                        Curve.Kind.HERMITE,
                        a -> new double[] {a[0], a[1], a[3], a[2]}),
                hermite(
                        "derivatives-between-ends",
                        Curve.Kind.HERMITE,
                        a -> new double[] {a[0], a[3], a[1], a[2]}));
    }

    private interface Flatten {
        void flatten(Curve curve, double flatness, CurvePoints out);
    }

    private interface At {
        void at(Curve curve, double[] t, CurvePoints out);
    }

    private static CurveTracer tracing(Flatten flatten, At at) {
        return new CurveTracer() {
            @Override
            public void at(Curve curve, double[] t, CurvePoints out) {
                at.at(curve, t, out);
            }

            @Override
            public void flatten(Curve curve, double flatness, CurvePoints out) {
                flatten.flatten(curve, flatness, out);
            }
        };
    }

    private static CurveTracer flattening(UnaryOperator<List<double[]>> change) {
        return tracing(
                (curve, flatness, out) -> {
                    List<double[]> points = new ArrayList<>();
                    RIGHT.flatten(curve, flatness, (x, y) -> points.add(new double[] {x, y}));
                    for (double[] each : change.apply(points)) out.point(each[0], each[1]);
                },
                RIGHT::at);
    }

    private static List<double[]> withoutRepeated(List<double[]> points) {
        var kept = new ArrayList<double[]>();
        double[] last = {Double.NaN, Double.NaN};
        for (double[] each : points) {
            if (each[0] != last[0] || each[1] != last[1]) kept.add(each);
            last = each;
        }
        return kept;
    }

    private static void atEqualSteps(Curve curve, double[] t, CurvePoints out) {
        var even = new double[t.length];
        for (int i = 0; i < t.length; i++)
            even[i] = t.length == 1 ? t[0] : t[0] + (t[t.length - 1] - t[0]) * i / (t.length - 1);
        RIGHT.at(curve, even, out);
    }

    private static Curve throughPoints(Curve curve) {
        return curve.kind() == Curve.Kind.B_SPLINE
                ? new Curve(Curve.Kind.CATMULL_ROM, curve.x(), curve.y())
                : curve;
    }

    /** Puts the weights t and 1 − t in each other's place. */
    private static void atBackwards(Curve curve, double[] t, CurvePoints out) {
        var backwards = new double[t.length];
        for (int i = 0; i < t.length; i++) backwards[i] = 1 - t[i];
        RIGHT.at(curve, backwards, out);
    }

    /**
     * A Hermite curve of other numbers.
     *
     * @param kind they are taken for
     * @param change of start, end and derivatives of a coordinate
     */
    private static Mutant<CurveTracer> hermite(
            String name, Curve.Kind kind, UnaryOperator<double[]> change) {
        UnaryOperator<Curve> changed =
                curve ->
                        curve.kind() == Curve.Kind.HERMITE
                                ? new Curve(kind, change.apply(curve.x()), change.apply(curve.y()))
                                : curve;
        return new Mutant<>(
                name,
                "hermite",
                tracing(
                        (curve, flatness, out) ->
                                RIGHT.flatten(changed.apply(curve), flatness, out),
                        (curve, t, out) -> RIGHT.at(changed.apply(curve), t, out)));
    }

    private static void chordOfClosed(Curve curve, double flatness, CurvePoints out) {
        int last = curve.x().length - 1;
        if (curve.x()[0] != curve.x()[last] || curve.y()[0] != curve.y()[last])
            RIGHT.flatten(curve, flatness, out);
        else for (int i = 0; i < 2; i++) out.point(curve.x()[0], curve.y()[0]);
    }
}
