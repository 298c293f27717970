package rasterlab.engine.light.normals;

import java.util.List;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.study.Slip;

/** Normals of vertices by a mistaken cross product, weight or length. */
final class NormalsSlips {
    private NormalsSlips() {}

    static List<Slip<VertexNormals>> of(VertexNormals right) {
        return List.of(
                Slip.of(
                        "squares-of-areas",
                        summed((n, length) -> length, NormalsSlips::difference, false)),
                Slip.of(
                        "divided-by-the-areas",
                        summed((n, length) -> 1, NormalsSlips::difference, true)),
                Slip.of("first-face-alone", NormalsSlips::firstFace),
                Slip.of(
                        "places-as-normals",
                        (vertices, triangles) -> vertices.clone(),
                        (vertices, triangles) -> unit(vertices.clone())),
                Slip.of(
                        "one-edge-from-the-origin",
                        summed(
                                (n, length) -> 1,
                                (p, to, from, second) -> from(p, to, second ? -1 : from),
                                false),
                        summed(
                                (n, length) -> 1,
                                (p, to, from, second) -> from(p, to, second ? from : -1),
                                false)),
                Slip.of("sign-in-the-cross-product", signed(0), signed(1), signed(2)),
                Slip.of("largest-not-length", NormalsSlips::byLargest));
    }

    private interface Weight {
        /** The factor of a face's cross product of that length. */
        double of(double[] cross, double length);
    }

    private interface Edge {
        double[] of(double[] vertices, int to, int from, boolean second);
    }

    /**
     * The sum of the faces' cross products.
     *
     * @param byArea whether it is divided by the sum of the areas, not by its length
     */
    private static VertexNormals summed(Weight weight, Edge edge, boolean byArea) {
        return (vertices, triangles) -> {
            var sums = new double[vertices.length];
            var areas = new double[vertices.length / 3];
            for (int t = 0; t < triangles.length; t += 3) {
                int a = triangles[t];
                double[] u = edge.of(vertices, triangles[t + 1], a, false);
                double[] v = edge.of(vertices, triangles[t + 2], a, true);
                double[] n = cross(u, v);
                double factor = weight.of(n, length(n));
                for (int k = 0; k < 3; k++) add(sums, triangles[t + k], n, factor);
                for (int k = 0; k < 3; k++) areas[triangles[t + k]] += length(n);
            }
            if (!byArea) return unit(sums);
            for (int i = 0; i < sums.length; i++) if (areas[i / 3] > 0) sums[i] /= areas[i / 3];
            return sums;
        };
    }

    private static VertexNormals signed(int component) {
        return (vertices, triangles) -> {
            var sums = new double[vertices.length];
            for (int t = 0; t < triangles.length; t += 3) {
                double[] n = ofFace(vertices, triangles, t);
                n[component] = -n[component];
                for (int k = 0; k < 3; k++) add(sums, triangles[t + k], n, 1);
            }
            return unit(sums);
        };
    }

    private static double[] firstFace(double[] vertices, int[] triangles) {
        var sums = new double[vertices.length];
        for (int t = 0; t < triangles.length; t += 3) {
            double[] n = ofFace(vertices, triangles, t);
            for (int k = 0; k < 3; k++) {
                int at = 3 * triangles[t + k];
                if (sums[at] == 0 && sums[at + 1] == 0 && sums[at + 2] == 0)
                    add(sums, triangles[t + k], n, 1);
            }
        }
        return unit(sums);
    }

    private static double[] byLargest(double[] vertices, int[] triangles) {
        var sums = new double[vertices.length];
        for (int t = 0; t < triangles.length; t += 3)
            for (int k = 0; k < 3; k++)
                add(sums, triangles[t + k], ofFace(vertices, triangles, t), 1);
        for (int i = 0; i < sums.length; i += 3) {
            double all = 0;
            for (int k = 0; k < 3; k++) all += Math.abs(sums[i + k]);
            for (int k = 0; k < 3; k++) if (all > 0) sums[i + k] /= all;
        }
        return sums;
    }

    private static double[] ofFace(double[] vertices, int[] triangles, int t) {
        return cross(
                from(vertices, triangles[t + 1], triangles[t]),
                from(vertices, triangles[t + 2], triangles[t]));
    }

    private static double[] difference(double[] p, int to, int from, boolean second) {
        return from(p, to, from);
    }

    /** The way from one vertex to another; from the origin where that is −1. */
    private static double[] from(double[] p, int to, int from) {
        var way = new double[3];
        for (int k = 0; k < 3; k++) way[k] = p[3 * to + k] - (from < 0 ? 0 : p[3 * from + k]);
        return way;
    }

    private static void add(double[] sums, int vertex, double[] n, double factor) {
        for (int k = 0; k < 3; k++) sums[3 * vertex + k] += factor * n[k];
    }

    private static double[] cross(double[] u, double[] v) {
        return new double[] {
            u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
        };
    }

    private static double length(double[] n) {
        return Math.hypot(n[0], Math.hypot(n[1], n[2]));
    }

    /** Brings each three numbers to length 1; (0, 0, 0) stays. */
    private static double[] unit(double[] all) {
        for (int i = 0; i < all.length; i += 3) {
            double length = Math.hypot(all[i], Math.hypot(all[i + 1], all[i + 2]));
            for (int k = 0; k < 3; k++) if (length > 0) all[i + k] /= length;
        }
        return all;
    }
}
