package rasterlab.engine.pipeline.fast;

import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;

/**
 * Finds what is seen at a pixel's centre by asking every triangle: slow and plain.
 *
 * <p>With clip coordinates (x, y, z, w) of the corners in doubles, the centre (X, Y) of −1..1 is on
 * the triangle where weights b ≥ 0 exist with {@code Σ b·(x, y, w) = (X, Y, 1)·h}; b normalised to
 * sum 1 are the true weights on the triangle in space, so attributes are Σ b·a and depth is that of
 * the point, with no division of vertices, no clipping and no rounding to steps.
 */
final class ExactPixel {
    private static final double[][] STEPS = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

    private final TriangleMesh mesh;
    private final double[] toClip;
    private final double[] weights = new double[3];

    /** Depth 0 to 1 of what is seen; 1 where nothing is. */
    double depth;

    /** How much the depth changes within reach. */
    double slack;

    /** Red, green, blue of what is seen, in levels. */
    final double[] rgb = new double[3];

    /** Whether another triangle's edge or depth is so near that rounding may decide. */
    boolean doubtful;

    /**
     * @param toClip world → clip, row by row
     */
    ExactPixel(TriangleMesh mesh, double[] toClip) {
        this.mesh = mesh;
        this.toClip = toClip;
    }

    /**
     * Looks through (X, Y) of −1..1.
     *
     * @param reach how far, in −1..1, an edge may be off
     */
    void look(double ndcX, double ndcY, double reach) {
        depth = 1;
        slack = 0;
        doubtful = false;
        int at = -1;
        double[] best = new double[3];
        for (int t = 0; t < mesh.triangleCount(); t++) {
            double least = 2;
            double most = -1;
            for (double[] step : STEPS) {
                double near = hit(t, ndcX + reach * step[0], ndcY + reach * step[1]);
                least = Math.min(least, near);
                most = Math.max(most, near);
            }
            double here = hit(t, ndcX, ndcY);
            if (least < 0 && most >= 0) doubtful = true;
            if (here < 0) continue;
            if (Math.abs(here - depth) < 1e-4) doubtful = true;
            if (here >= depth) continue;
            depth = here;
            slack = (most - least) / 2;
            at = t;
            System.arraycopy(weights, 0, best, 0, 3);
        }
        if (at >= 0) color(at, best);
    }

    private void color(int t, double[] best) {
        VertexQuantity[] channels = {VertexQuantity.RED, VertexQuantity.GREEN, VertexQuantity.BLUE};
        for (int i = 0; i < 3; i++) {
            rgb[i] = 0;
            for (int k = 0; k < 3; k++)
                rgb[i] += 255 * best[k] * mesh.values(channels[i])[mesh.triangles()[3 * t + k]];
        }
    }

    /** The depth where the sight meets the triangle within the view, else −1; sets the weights. */
    private double hit(int t, double ndcX, double ndcY) {
        double[][] p = new double[3][];
        for (int k = 0; k < 3; k++) p[k] = clip(mesh.triangles()[3 * t + k]);
        double[] sight = {ndcX, ndcY, 1};
        double all = determinant(p[0], p[1], p[2]);
        if (all == 0) return -1;
        weights[0] = determinant(sight, p[1], p[2]) / all;
        weights[1] = determinant(p[0], sight, p[2]) / all;
        weights[2] = determinant(p[0], p[1], sight) / all;
        double sum = weights[0] + weights[1] + weights[2];
        double z = 0;
        double w = 0;
        for (int k = 0; k < 3; k++) {
            weights[k] /= sum;
            if (!(weights[k] >= 0)) return -1;
            z += weights[k] * p[k][3];
            w += weights[k] * p[k][2];
        }
        return w > 0 && Math.abs(z) <= w ? (z / w + 1) / 2 : -1;
    }

    /** x, y, w, z. */
    private double[] clip(int vertex) {
        double x = mesh.values(VertexQuantity.X)[vertex];
        double y = mesh.values(VertexQuantity.Y)[vertex];
        double z = mesh.values(VertexQuantity.Z)[vertex];
        double[] clip = new double[4];
        for (int i = 0; i < 4; i++)
            clip[i] = x * toClip[i] + y * toClip[4 + i] + z * toClip[8 + i] + toClip[12 + i];
        return new double[] {clip[0], clip[1], clip[3], clip[2]};
    }

    private static double determinant(double[] a, double[] b, double[] c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1])
                - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
}
