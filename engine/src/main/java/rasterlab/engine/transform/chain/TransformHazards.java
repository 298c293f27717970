package rasterlab.engine.transform.chain;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;
import static rasterlab.engine.transform.chain.TransformWorkloads.cells;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Chains in which digits cancel, and points at and behind the eye. */
final class TransformHazards {
    private static final String TEXTBOOK = "divide-first-textbook";
    private static final String FLOAT = "float";
    private static final String DOUBLE = "double";

    private TransformHazards() {}

    static List<Hazard<Chain>> all() {
        return Stream.of(order(), eye(), cancellation()).flatMap(List::stream).toList();
    }

    private static List<Hazard<Chain>> order() {
        return List.of(
                hazard(
                        "shift-then-turn",
                        Map.of(),
                        new double[] {1, 2, 3},
                        cells("TRANSL3D", 4, 0, 0),
                        cells("ROT3DZ", 90)),
                hazard(
                        "shift-in-the-last-row",
                        Map.of(),
                        new double[] {1, 2, 3},
                        cells("TRANSL3D", 4, 5, 6)));
    }

    private static List<Hazard<Chain>> eye() {
        return List.of(
                hazard(
                        "at-the-eye",
                        Map.of(TEXTBOOK, WRONG),
                        new double[] {3, 4, 512},
                        cells("PERSPECTIVE", 0, 0, -1 / 512.0)),
                hazard(
                        "behind-the-eye",
                        Map.of(TEXTBOOK, WRONG),
                        new double[] {3, 4, 1024},
                        cells("PERSPECTIVE", 0, 0, -1 / 512.0)),
                hazard(
                        "nearly-at-the-eye",
                        Map.of(TEXTBOOK, WRONG, FLOAT, WRONG, DOUBLE, WRONG),
                        new double[] {3, 4, 700},
                        cells("PERSPECTIVE", 0, 0, -1 / 700.0)),
                hazard(
                        "close-to-the-eye",
                        Map.of(TEXTBOOK, WRONG, FLOAT, WRONG, DOUBLE, DEGRADED),
                        new double[] {3, 4, 700 - 7e-7},
                        cells("PERSPECTIVE", 0, 0, -1 / 700.0)),
                homogeneous(
                        "vanishing-point",
                        Map.of(TEXTBOOK, WRONG),
                        new double[] {0, 0, 1},
                        0,
                        cells("PERSPECTIVE", 0, 0, 0.25)),
                homogeneous(
                        "stays-at-infinity",
                        Map.of(TEXTBOOK, WRONG),
                        new double[] {3, 4, 0},
                        0,
                        cells("TRANSL3D", 5, 6, 7)),
                homogeneous(
                        "many-representations",
                        Map.of(TEXTBOOK, WRONG),
                        new double[] {3, 4, 5},
                        -2,
                        cells("TRANSL3D", 1, 0, 0)));
    }

    private static List<Hazard<Chain>> cancellation() {
        return List.of(
                hazard(
                        "shift-there-and-back",
                        Map.of(TEXTBOOK, WRONG, FLOAT, WRONG, DOUBLE, WRONG),
                        new double[] {0.25, 0.5, 0.75},
                        cells("TRANSL3D", 1e15, 0, 0),
                        cells("TRANSL3D", 0.1, 0, 0),
                        cells("TRANSL3D", -1e15, 0, 0)),
                hazard(
                        "turn-about-a-far-point",
                        Map.of(TEXTBOOK, DEGRADED, FLOAT, WRONG, DOUBLE, DEGRADED),
                        new double[] {1e6 + 1, 2, 1e6},
                        cells("TRANSL3D", -1e6, 0, -1e6),
                        cells("ROT3DY", 30),
                        cells("TRANSL3D", 1e6, 0, 1e6),
                        cells("TRANSL3D", -1e6, 0, -1e6)),
                hazard(
                        "flattened",
                        Map.of(),
                        new double[] {3, 4, 5},
                        cells("ORTHOZ", 2),
                        cells("SCALE3DX", 2)),
                hazard(
                        "beyond-float",
                        Map.of(FLOAT, REFUSED),
                        new double[] {1e200, 2e200, 3e200},
                        cells("SCALE3DX", 2)));
    }

    private static Hazard<Chain> homogeneous(
            String name,
            Map<String, Verdict.Kind> failing,
            double[] point,
            double h,
            double[]... matrices) {
        return Hazard.allExactBut(
                failing,
                TransformMethods.all(),
                name,
                new Chain(3, matrices, point, new double[] {h}));
    }

    private static Hazard<Chain> hazard(
            String name, Map<String, Verdict.Kind> failing, double[] points, double[]... matrices) {
        return Hazard.allExactBut(
                failing, TransformMethods.all(), name, new Chain(3, matrices, points));
    }
}
