package rasterlab.engine.polygon.triangulation;

import java.util.List;
import rasterlab.contract.Triangulator;
import rasterlab.engine.study.Slip;

/** Triangles by a pattern of numbers, whatever the polygon. */
final class TriangulateSlips {
    private TriangulateSlips() {}

    static List<Slip<Triangulator>> of(Triangulator right) {
        return List.of(
                Slip.of(
                        "fan-from-the-last",
                        pattern((n, t) -> new int[] {n - 1, t, t + 1}),
                        pattern((n, t) -> new int[] {n - 1, t + 1, t})),
                Slip.of("strip-of-neighbours", pattern((n, t) -> new int[] {t, t + 1, t + 2})),
                Slip.of("fan-clockwise", pattern((n, t) -> new int[] {0, t + 2, t + 1})),
                Slip.of(
                        "triangle-at-each-vertex",
                        (x, y) -> {
                            int n = x.length;
                            var all = new int[3 * n];
                            for (int i = 0; i < all.length; i++) all[i] = (i / 3 + i % 3) % n;
                            return all;
                        }));
    }

    private interface Pattern {
        /** Numbers of the corners of one triangle of those that n vertices have. */
        int[] of(int n, int triangle);
    }

    private static Triangulator pattern(Pattern pattern) {
        return (x, y) -> {
            var all = new int[3 * (x.length - 2)];
            for (int t = 0; t < x.length - 2; t++)
                System.arraycopy(pattern.of(x.length, t), 0, all, 3 * t, 3);
            return all;
        };
    }
}
