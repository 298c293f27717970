package rasterlab.engine.spline.function;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Points on which a spline fails, with what each method is known to make of them. */
final class SplineHazards {
    private SplineHazards() {}

    static List<Hazard<SplineProblem>> all() {
        return List.of(
                refused(
                        "equal-knots",
                        problem(points(0, 1, 1, 2), points(0, 1, 2, 3), SplineEnds.natural())),
                refused(
                        "unordered-knots",
                        problem(points(0, 2, 1, 3), points(0, 1, 2, 3), SplineEnds.natural())),
                refused(
                        "not-a-number",
                        problem(points(0, 1, 2), points(0, Double.NaN, 2), SplineEnds.natural())),
                refused("single-knot", problem(points(1), points(1), SplineEnds.natural())),
                refused(
                        "period-does-not-close",
                        problem(points(0, 1, 2), points(0, 1, 0.5), SplineEnds.periodic())),
                refused(
                        "widths-at-the-limit",
                        problem(
                                points(-Double.MAX_VALUE, 0, Double.MAX_VALUE),
                                points(0, 1, 0),
                                SplineEnds.natural())),
                overshoot(),
                exact(
                        "uneven-knots",
                        WRONG,
                        problem(
                                points(0, 1, 1.000001, 2, 2.000001, 5, 5.5),
                                points(0, 1, 1.5, -1, -1.000001, 2, 0),
                                SplineEnds.notAKnot())),
                exact(
                        "far-from-zero",
                        DEGRADED,
                        problem(
                                points(1e9, 1e9 + 1, 1e9 + 3, 1e9 + 4),
                                points(5e9, 5e9 + 2, 5e9 - 1, 5e9),
                                SplineEnds.slopes(1, -1))),
                exact(
                        "periodic",
                        WRONG,
                        problem(
                                points(0, 1, 2.5, 3, 4),
                                points(0, 1, 0.5, -1, 0),
                                SplineEnds.periodic())),
                exact(
                        "three-knots",
                        WRONG,
                        problem(points(0, 1, 3), points(0, 1, 9), SplineEnds.notAKnot())),
                exact(
                        "two-knots",
                        EXACT,
                        problem(points(0, 2), points(1, 2), SplineEnds.slopes(3, 0.5))));
    }

    private static Hazard<SplineProblem> overshoot() {
        double[] x = points(0, 1, 2, 3, 4, 5, 6, 7);
        double[] step = points(0, 0, 0, 0, 1, 1, 1, 1);
        return hazard(
                "overshoot",
                new SplineProblem(x, step, SplineEnds.natural(), between(x), true),
                Map.of("cubic-textbook", EXACT));
    }

    private static Hazard<SplineProblem> refused(String name, SplineProblem p) {
        return hazard(
                name, p, Map.of("cubic", REFUSED, "monotone", REFUSED, "cubic-textbook", WRONG));
    }

    private static Hazard<SplineProblem> exact(
            String name, Verdict.Kind textbook, SplineProblem p) {
        return hazard(name, p, Map.of("cubic-textbook", textbook));
    }

    private static Hazard<SplineProblem> hazard(
            String name, SplineProblem problem, Map<String, Verdict.Kind> failing) {
        return Hazard.allExactBut(failing, SplineMethods.all(), name, problem);
    }

    private static SplineProblem problem(double[] x, double[] y, SplineEnds ends) {
        return new SplineProblem(x, y, ends, between(x), false);
    }

    /** 64 equal steps from the first knot to the last. */
    private static double[] between(double[] x) {
        double width = x[x.length - 1] - x[0];
        return DoubleStream.iterate(0, k -> k + 1)
                .limit(65)
                .map(k -> x[0] + width * (k / 64))
                .toArray();
    }

    private static double[] points(double... numbers) {
        return numbers;
    }
}
