package rasterlab.engine.pipeline.paint;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * How much each corner of a triangle counts at a pixel, with perspective.
 *
 * <p>Faces are taken as fans of triangles about their first corners. With P0, P1, P2 a triangle's
 * corners in eye space and (X, Y) a place on the picture plane, row i of the inverse of the matrix
 * with columns P0 P1 P2, times (X/ρ, Y/ρ, 1), is λ'ᵢ: linear in the pixel, and λ'₀ + λ'₁ + λ'₂ =
 * 1/z. The weights are λᵢ = z·λ'ᵢ. In parallel projection the corners are (x, y, 1), the place is
 * (X, Y, 1) and λ'ᵢ = λᵢ.
 *
 * <p>A pixel that its method counts to a face beyond its edges has the weights of the edge. A
 * triangle seen exactly edge-on has no inverse; its corners count alike.
 *
 * <p>Source: P. S. Heckbert, H. P. Moreton, Interpolation for polygon texture mapping and shading,
 * 1991, pp. 101–111.
 */
final class CornerWeights {
    private static final int ROW = 9;

    private final ViewedMesh view;
    private final Mesh mesh;
    private final double scale;

    /** The base of λ'₀, λ'₁, λ'₂ of each triangle, their steps to the right, their steps down. */
    private final double[] linear;

    CornerWeights(ViewedMesh view) {
        this.view = view;
        mesh = view.mesh();
        scale = view.transform().central() ? 1 / view.transform().distance() : 1;
        linear = new double[ROW * (mesh.totalCorners() - 2 * mesh.faceCount())];
        for (int face = 0; face < mesh.faceCount(); face++)
            for (int fan = 1; fan + 1 < mesh.cornerCount(face); fan++) invert(face, fan);
    }

    /** Where the numbers of a triangle begin. */
    private int at(int face, int fan) {
        return ROW * (mesh.firstCorner(face) - 2 * face + fan - 1);
    }

    private void invert(int face, int fan) {
        double[] p0 = corner(face, 0);
        double[] p1 = corner(face, fan);
        double[] p2 = corner(face, fan + 1);
        double[][] rows = {cross(p1, p2), cross(p2, p0), cross(p0, p1)};
        double volume = p0[0] * rows[0][0] + p0[1] * rows[0][1] + p0[2] * rows[0][2];
        if (volume == 0) return;
        PictureFit fit = view.fit();
        int at = at(face, fan);
        for (int i = 0; i < 3; i++) {
            double perX = scale * rows[i][0] / volume;
            double perY = scale * rows[i][1] / volume;
            linear[at + i] = rows[i][2] / volume + perX * fit.toPlaneX(0) + perY * fit.toPlaneY(0);
            linear[at + 3 + i] = perX / fit.pixelsPerUnit();
            linear[at + 6 + i] = -perY / fit.pixelsPerUnit();
        }
    }

    private double[] corner(int face, int corner) {
        int v = mesh.corner(face, corner);
        double z = view.transform().central() ? view.eyeZ(v) : 1;
        return new double[] {view.eyeX(v), view.eyeY(v), z};
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        };
    }

    /** One corner's step of λ' to the right. */
    double perColumn(int face, int fan, int corner) {
        return linear[at(face, fan) + 3 + corner];
    }

    /** One corner's step of λ' downwards. */
    double perRow(int face, int fan, int corner) {
        return linear[at(face, fan) + 6 + corner];
    }

    /** Fills a row with the weights and depths of the pixels [from, to) of row y. */
    void load(int face, int y, int from, int to, PixelRow row) {
        row.size = to - from;
        int triangles = mesh.cornerCount(face) - 2;
        int fan = 1;
        for (int i = 0; i < row.size; i++) {
            if (triangles > 1) fan = triangle(face, fan, from + i, y);
            int at = at(face, fan);
            weigh(at, from + i, y, row, i);
            row.fan[i] = fan;
            row.depth[i] =
                    row.weight0[i] * view.eyeZ(mesh.corner(face, 0))
                            + row.weight1[i] * view.eyeZ(mesh.corner(face, fan))
                            + row.weight2[i] * view.eyeZ(mesh.corner(face, fan + 1));
        }
    }

    private void weigh(int at, int x, int y, PixelRow row, int i) {
        double w0 = Math.max(0, weight(at, x, y));
        double w1 = Math.max(0, weight(at + 1, x, y));
        double w2 = Math.max(0, weight(at + 2, x, y));
        double sum = w0 + w1 + w2;
        boolean known = sum > 0;
        row.weight0[i] = known ? w0 / sum : 1 / 3.0;
        row.weight1[i] = known ? w1 / sum : 1 / 3.0;
        row.weight2[i] = known ? w2 / sum : 1 / 3.0;
    }

    private double weight(int at, int x, int y) {
        return linear[at] + x * linear[at + 3] + y * linear[at + 6];
    }

    /** The triangle that holds a pixel, or the one it lies beyond by the least share. */
    private int triangle(int face, int guess, int x, int y) {
        if (least(at(face, guess), x, y) >= 0) return guess;
        int best = guess;
        double highest = Double.NEGATIVE_INFINITY;
        for (int fan = 1; fan + 1 < mesh.cornerCount(face); fan++) {
            double least = least(at(face, fan), x, y);
            if (least > highest) {
                highest = least;
                best = fan;
            }
        }
        return best;
    }

    /** The smallest of the three weights; negative infinity where the triangle has none. */
    private double least(int at, int x, int y) {
        double w0 = weight(at, x, y);
        double w1 = weight(at + 1, x, y);
        double w2 = weight(at + 2, x, y);
        double sum = w0 + w1 + w2;
        return sum > 0 ? Math.min(w0, Math.min(w1, w2)) / sum : Double.NEGATIVE_INFINITY;
    }
}
