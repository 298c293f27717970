package rasterlab.engine.spline.curve;

import static rasterlab.contract.Curve.Kind.BEZIER;
import static rasterlab.contract.Curve.Kind.B_SPLINE;
import static rasterlab.contract.Curve.Kind.CATMULL_ROM;
import static rasterlab.contract.Curve.Kind.HERMITE;
import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Curves on which methods fail, with what each method is known to make of them. */
final class CurveHazards {
    private static final String BLENDING = "blending-textbook";
    private static final String MATRIX = "matrix";
    private static final String HORNER = "horner";
    private static final String DIFFERENCES = "forward-differences";
    private static final String FLOAT = "forward-differences-float";
    private static final String NAIVE = "adaptive-naive";
    private static final String UNCHECKED = "curvature-unchecked";
    private static final double[] X_OF_S = {20, 120, 220, 320};
    private static final double[] ARCH_X = {10, 60, 180, 250};
    private static final double[] ARCH_Y = {200, 20, 40, 190};

    private CurveHazards() {}

    static List<Hazard<CurveTask>> all() {
        return List.of(
                first(),
                hermite(),
                drift(),
                unequalSteps(),
                highDegree(),
                joined("catmull-rom-joints", CATMULL_ROM, WRONG),
                joined("b-spline-joints", B_SPLINE, EXACT),
                flat("arch", ARCH_X, ARCH_Y, Map.of(BLENDING, WRONG)),
                flat(
                        "from-start-to-end",
                        of(30, 90, 40, 200),
                        of(10, 150, 230, 60),
                        Map.of(BLENDING, WRONG)),
                flat(
                        "s-curve",
                        X_OF_S,
                        of(100, 250, -50, 100),
                        Map.of(BLENDING, WRONG, NAIVE, WRONG, UNCHECKED, DEGRADED)),
                flat("cusp", of(10, 310, 10, 310), of(20, 320, 320, 20), Map.of(BLENDING, WRONG)),
                flat("loop", of(0, 400, -250, 150), of(200, 0, 0, 200), Map.of(BLENDING, WRONG)),
                flat(
                        "closed-loop",
                        of(100, 300, -100, 100),
                        of(200, 0, 0, 200),
                        Map.of(BLENDING, WRONG)),
                flat(
                        "collinear-beyond-the-ends",
                        of(10, 510, -390, 110),
                        of(50, 50, 50, 50),
                        Map.of(BLENDING, WRONG, NAIVE, WRONG, UNCHECKED, WRONG)),
                flat("coincident-points", of(70, 70, 70, 70), of(40, 40, 40, 40), Map.of()),
                huge(),
                tiny(),
                tooFine());
    }

    private static Hazard<CurveTask> first() {
        return hazard(
                "bezier-erratum",
                CurveTask.at(new Curve(BEZIER, ARCH_X, ARCH_Y), equalSteps(8)),
                Map.of(BLENDING, WRONG));
    }

    private static Hazard<CurveTask> hermite() {
        return hazard(
                "hermite",
                CurveTask.flat(
                        new Curve(HERMITE, of(20, 240, 400, -300), of(30, 60, 500, 450)), 0.25),
                Map.of());
    }

    private static Hazard<CurveTask> drift() {
        return hazard(
                "drift",
                CurveTask.at(new Curve(BEZIER, ARCH_X, ARCH_Y), equalSteps(10_000)),
                Map.of(BLENDING, WRONG, FLOAT, WRONG));
    }

    private static Hazard<CurveTask> unequalSteps() {
        return hazard(
                "unequal-steps",
                CurveTask.at(new Curve(BEZIER, ARCH_X, ARCH_Y), 0, 0.1, 0.9, 1),
                Map.of(BLENDING, WRONG, DIFFERENCES, REFUSED, FLOAT, REFUSED));
    }

    private static Hazard<CurveTask> highDegree() {
        double[] x = IntStream.range(0, 41).mapToDouble(i -> 10 * i).toArray();
        double[] y = IntStream.range(0, 41).mapToDouble(i -> (i & 1) * 300.0).toArray();
        return hazard(
                "degree-40",
                CurveTask.at(new Curve(BEZIER, x, y), equalSteps(16)),
                Map.of(
                        BLENDING, REFUSED,
                        MATRIX, REFUSED,
                        HORNER, REFUSED,
                        DIFFERENCES, REFUSED,
                        FLOAT, REFUSED));
    }

    private static Hazard<CurveTask> joined(String name, Curve.Kind kind, Verdict.Kind naive) {
        double[] x = of(0, 40, 90, 160, 160, 30, 200);
        double[] y = of(0, 200, 10, 90, 90, 300, 150);
        return hazard(
                name,
                CurveTask.flat(new Curve(kind, x, y), 0.25),
                Map.of(BLENDING, REFUSED, NAIVE, naive));
    }

    private static Hazard<CurveTask> huge() {
        double[] x = of(0, 1e90, 2e90, 3e90);
        return hazard(
                "huge",
                CurveTask.flat(new Curve(BEZIER, x, of(1e90, 2e90, 2e90, 0)), 1e87),
                Map.of(BLENDING, WRONG, FLOAT, REFUSED));
    }

    private static Hazard<CurveTask> tiny() {
        double[] x = of(0, 1e-90, 2e-90, 3e-90);
        return hazard(
                "tiny",
                CurveTask.flat(new Curve(BEZIER, x, of(1e-90, 2e-90, 2e-90, 0)), 1e-93),
                Map.of(BLENDING, WRONG, FLOAT, WRONG));
    }

    private static Hazard<CurveTask> tooFine() {
        var curve = new Curve(BEZIER, of(1e9, 2e9, 3e9, 4e9), of(0, 1e9, 1e9, 0));
        var verdicts = new TreeMap<String, Verdict.Kind>();
        for (var method : CurveMethods.all()) verdicts.put(method.name(), REFUSED);
        return hazard("finer-than-doubles", CurveTask.flat(curve, 1e-9), verdicts);
    }

    private static Hazard<CurveTask> flat(
            String name, double[] x, double[] y, Map<String, Verdict.Kind> failing) {
        var task = CurveTask.flat(new Curve(BEZIER, x, y), 0.25);
        return hazard(name, task, failing);
    }

    /** Methods that are not named are exact. */
    private static Hazard<CurveTask> hazard(
            String name, CurveTask task, Map<String, Verdict.Kind> failing) {
        return Hazard.allExactBut(failing, CurveMethods.all(), name, task);
    }

    private static double[] equalSteps(int steps) {
        return IntStream.rangeClosed(0, steps).mapToDouble(i -> (double) i / steps).toArray();
    }

    private static double[] of(double... numbers) {
        return numbers;
    }
}
