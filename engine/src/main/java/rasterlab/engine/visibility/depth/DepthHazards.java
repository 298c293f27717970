package rasterlab.engine.visibility.depth;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.contract.DepthRange;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Depths that formats cannot tell apart, and scan lines along which sums drift. */
final class DepthHazards {
    private static final int LONG = 8192;

    private DepthHazards() {}

    static List<Hazard<DepthRows>> all() {
        return Stream.of(ratios(), planes(), rows()).flatMap(List::stream).toList();
    }

    private static List<Hazard<DepthRows>> ratios() {
        return List.of(
                hazard("far-near-10", DepthRows.pixel(new DepthRange(1, 10), 8, 9), Map.of()),
                hazard(
                        "far-near-1000",
                        DepthRows.pixel(new DepthRange(1, 1e3), 900, 901),
                        Map.of("z16", WRONG, "incremental-z16", WRONG)),
                hazard(
                        "far-near-million",
                        DepthRows.pixel(new DepthRange(1, 1e6), 900_010, 900_011),
                        Map.of(
                                "z16", WRONG,
                                "z24", WRONG,
                                "z32", DEGRADED,
                                "zfloat", WRONG,
                                "linear-16", DEGRADED,
                                "incremental-z16", WRONG,
                                "incremental-z24", WRONG,
                                "incremental-float", WRONG)),
                hazard(
                        "no-far-plane",
                        DepthRows.pixel(
                                new DepthRange(1, Double.POSITIVE_INFINITY), 1_000_000, 1_000_001),
                        Map.of(
                                "z16", WRONG,
                                "z24", WRONG,
                                "z32", DEGRADED,
                                "zfloat", WRONG,
                                "linear-16", REFUSED,
                                "incremental-z16", WRONG,
                                "incremental-z24", WRONG,
                                "incremental-float", WRONG)),
                hazard(
                        "near-next-to-the-eye",
                        DepthRows.pixel(new DepthRange(1e-9, 100), 10, 10.5),
                        Map.of(
                                "z16", WRONG,
                                "z24", WRONG,
                                "z32", WRONG,
                                "zfloat", WRONG,
                                "incremental-z16", WRONG,
                                "incremental-z24", WRONG,
                                "incremental-float", WRONG)));
    }

    private static List<Hazard<DepthRows>> planes() {
        return List.of(
                hazard(
                        "on-the-planes",
                        DepthRows.pixel(new DepthRange(1, 100), 1, 1.01, 99, 100),
                        Map.of()),
                hazard(
                        "twice-the-same",
                        new DepthRows(
                                new DepthRange(1, 1e3),
                                new double[] {3, 3},
                                new double[] {500, 500},
                                LONG),
                        Map.of()),
                hazard(
                        "close-to-the-eye",
                        DepthRows.pixel(new DepthRange(0.01, 1e4), 0.02, 0.05),
                        Map.of("linear-16", WRONG)));
    }

    private static List<Hazard<DepthRows>> rows() {
        return List.of(
                hazard(
                        "crossing",
                        new DepthRows(
                                new DepthRange(1, 100),
                                new double[] {10, 20},
                                new double[] {20, 10},
                                LONG),
                        Map.of(
                                "z16", DEGRADED,
                                "incremental-z16", DEGRADED,
                                "incremental-float", WRONG)),
                hazard(
                        "slope-through-a-wall",
                        new DepthRows(
                                new DepthRange(1, 100),
                                new double[] {10, 15},
                                new double[] {20, 15},
                                101),
                        Map.of()),
                hazard(
                        "drift-8192",
                        new DepthRows(
                                new DepthRange(1, 1e3),
                                new double[] {900, 1.5},
                                new double[] {900, 899.9},
                                LONG),
                        Map.of(
                                "z16", WRONG,
                                "incremental-z16", WRONG,
                                "incremental-z24", DEGRADED,
                                "incremental-float", WRONG)));
    }

    private static Hazard<DepthRows> hazard(
            String name, DepthRows rows, Map<String, Verdict.Kind> failing) {
        return Hazard.allExactBut(failing, DepthMethods.all(), name, rows);
    }
}
