package rasterlab.engine.visibility.triangle;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Triangles that one mistake shows on, in pictures of a few pixels. */
final class DepthTriangleHazards {
    private static final double[] SLANTED = {1, 0, 0.125, 13, 3, 0.875, 4, 9, 0.5};

    private static final double[] FAR = {0, 0, 0.9375, 13, 0, 0.9375, 0, 9, 0.9375};

    private DepthTriangleHazards() {}

    static List<Hazard<DepthTriangles>> all() {
        return Stream.of(sideBySide(), oneBehindTheOther(), farOrThin())
                .flatMap(List::stream)
                .toList();
    }

    private static List<Hazard<DepthTriangles>> sideBySide() {
        return List.of(
                hazard(
                        "one-triangle",
                        Map.of(),
                        over(
                                1,
                                14,
                                10,
                                new double[] {1.5, 0.5, 0.5, 12.5, 2.5, 0.5, 4.5, 9.5, 0.5})),
                hazard(
                        "slanted",
                        Map.of("left-edge-textbook", WRONG, "rows-float", DEGRADED),
                        over(1, 14, 10, SLANTED)),
                hazard(
                        "either-way-round",
                        Map.of(),
                        over(
                                1,
                                14,
                                10,
                                new double[] {0, 0, 0.5, 6, 0, 0.5, 0, 6, 0.5},
                                new double[] {7, 0, 0.5, 7, 6, 0.5, 13, 6, 0.5})),
                hazard(
                        "on-the-edges",
                        Map.of(),
                        over(
                                1,
                                12,
                                10,
                                new double[] {1, 1, 0.25, 9, 1, 0.25, 1, 9, 0.25},
                                new double[] {9, 1, 0.75, 9, 9, 0.75, 1, 9, 0.75})));
    }

    private static List<Hazard<DepthTriangles>> oneBehindTheOther() {
        return List.of(
                hazard(
                        "nearer-first",
                        Map.of(),
                        over(
                                1,
                                14,
                                10,
                                new double[] {3, 1, 0.25, 11, 5, 0.25, 3, 9, 0.25},
                                new double[] {0, 0, 0.75, 13, 0, 0.75, 0, 9, 0.75})),
                hazard(
                        "through-each-other",
                        Map.of("left-edge-textbook", WRONG, "rows-float", DEGRADED),
                        over(
                                1,
                                16,
                                10,
                                new double[] {0, 0, 0.1, 15, 4, 0.9, 0, 9, 0.3},
                                new double[] {15, 0, 0.2, 15, 9, 0.2, 0, 5, 0.8})),
                hazard(
                        "same-again",
                        Map.of("left-edge-textbook", WRONG, "rows-float", DEGRADED),
                        over(1, 14, 10, SLANTED, SLANTED, FAR)),
                hazard(
                        "close-together",
                        Map.of("rows-float", WRONG),
                        over(
                                1,
                                14,
                                10,
                                new double[] {
                                    1, 0, 0.70000001, 13, 3, 0.70000001, 4, 9, 0.70000001
                                },
                                new double[] {1, 0, 0.7, 13, 3, 0.7, 4, 9, 0.7})),
                hazard(
                        "before-a-wall",
                        Map.of("left-edge-textbook", WRONG, "rows-float", DEGRADED),
                        over(0.4375, 14, 10, SLANTED)));
    }

    private static List<Hazard<DepthTriangles>> farOrThin() {
        return List.of(
                hazard(
                        "beyond-the-picture",
                        Map.of("left-edge-textbook", WRONG, "rows-float", DEGRADED),
                        over(1, 12, 8, new double[] {-40, 4, 0.25, 30, -31, 0.75, 37, 40, 0.5})),
                hazard(
                        "needle",
                        Map.of("slopes", DEGRADED, "rows-float", DEGRADED),
                        over(
                                1,
                                4,
                                3,
                                new double[] {
                                    -4095.99609375,
                                    -4095.9921875,
                                    0.2,
                                    4095.99609375,
                                    4095.9921875,
                                    0.7,
                                    -0.00390625,
                                    -0.00390625,
                                    0.4
                                })),
                hazard(
                        "corners-on-a-line",
                        Map.of(),
                        over(1, 12, 8, new double[] {1, 1, 0.25, 6, 4, 0.5, 11, 7, 0.75})));
    }

    private static DepthTriangles over(
            double background, int width, int height, double[]... triangles) {
        return new DepthTriangles(List.of(triangles), width, height, background);
    }

    private static Hazard<DepthTriangles> hazard(
            String name, Map<String, Verdict.Kind> failing, DepthTriangles input) {
        return Hazard.allExactBut(failing, new DepthTriangleTopic().methods(), name, input);
    }
}
