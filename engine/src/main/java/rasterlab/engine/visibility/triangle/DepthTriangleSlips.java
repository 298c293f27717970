package rasterlab.engine.visibility.triangle;

import java.util.List;
import rasterlab.contract.DepthTriangleFiller;
import rasterlab.engine.study.Slip;

/** Triangles with other pixels, or with other depths in the right ones. */
final class DepthTriangleSlips {
    private static final Covered RIGHT_PIXELS = (e, topLeft) -> e > 0 || e == 0 && topLeft;
    private static final Depth RIGHT_DEPTH = (a, b, c, z) -> a * z[0] + b * z[1] + c * z[2];

    private DepthTriangleSlips() {}

    static List<Slip<DepthTriangleFiller>> of(DepthTriangleFiller right) {
        return List.of(
                Slip.of("no-edge-counts", filler((e, topLeft) -> e > 0, 0, RIGHT_DEPTH)),
                Slip.of(
                        "right-and-bottom-edges-count",
                        filler((e, topLeft) -> e > 0 || e == 0 && !topLeft, 0, RIGHT_DEPTH)),
                Slip.of("half-a-pixel-on", filler(RIGHT_PIXELS, 0.5, RIGHT_DEPTH)),
                Slip.of("half-a-pixel-back", filler(RIGHT_PIXELS, -0.5, RIGHT_DEPTH)),
                Slip.of(
                        "weights-in-another-order",
                        filler(RIGHT_PIXELS, 0, (a, b, c, z) -> a * z[1] + b * z[2] + c * z[0]),
                        filler(RIGHT_PIXELS, 0, (a, b, c, z) -> a * z[2] + b * z[0] + c * z[1])),
                Slip.of(
                        "depth-by-1-over-z",
                        filler(
                                RIGHT_PIXELS,
                                0,
                                (a, b, c, z) -> 1 / (a / z[0] + b / z[1] + c / z[2]))),
                Slip.of(
                        "one-depth-for-all",
                        filler(RIGHT_PIXELS, 0, (a, b, c, z) -> (z[0] + z[1] + z[2]) / 3),
                        filler(RIGHT_PIXELS, 0, (a, b, c, z) -> z[0]),
                        filler(
                                RIGHT_PIXELS,
                                0,
                                (a, b, c, z) -> Math.min(z[0], Math.min(z[1], z[2]))),
                        filler(
                                RIGHT_PIXELS,
                                0,
                                (a, b, c, z) -> Math.max(z[0], Math.max(z[1], z[2])))),
                Slip.of(
                        "number-not-stored",
                        (x, y, z, number, width, height, depths, shown) ->
                                right.fill(x, y, z, number, width, height, depths, shown.clone())),
                Slip.of(
                        "x-y-swapped",
                        (x, y, z, number, width, height, depths, shown) ->
                                right.fill(y, x, z, number, width, height, depths, shown)));
    }

    private interface Covered {
        boolean by(double edge, boolean topLeft);
    }

    private interface Depth {
        /** Depth of a pixel, of which the corners have these shares. */
        double of(double a, double b, double c, double[] z);
    }

    /**
     * Fills by the three edges.
     *
     * @param shift from a pixel's whole coordinates to the point that is asked
     */
    private static DepthTriangleFiller filler(Covered covered, double shift, Depth depth) {
        return (x, y, z, number, width, height, depths, shown) -> {
            double area = edge(x, y, 0, 1, x[2], y[2]);
            if (area == 0) return;
            int[] order = area > 0 ? new int[] {0, 1, 2} : new int[] {0, 2, 1};
            var shares = new double[3];
            for (int row = 0; row < height; row++)
                for (int column = 0; column < width; column++) {
                    boolean in = true;
                    for (int k = 0; k < 3; k++) {
                        int i = order[(k + 1) % 3];
                        int j = order[(k + 2) % 3];
                        double e = edge(x, y, i, j, column + shift, row + shift);
                        boolean topLeft = y[i] == y[j] && x[j] > x[i] || y[j] < y[i];
                        in &= covered.by(e, topLeft);
                        shares[order[k]] = e / Math.abs(area);
                    }
                    if (!in) continue;
                    double at = depth.of(shares[0], shares[1], shares[2], z);
                    int pixel = row * width + column;
                    if (!(at < depths[pixel])) continue;
                    depths[pixel] = at;
                    shown[pixel] = number;
                }
        };
    }

    private static double edge(double[] x, double[] y, int i, int j, double px, double py) {
        return (x[j] - x[i]) * (py - y[i]) - (y[j] - y[i]) * (px - x[i]);
    }
}
