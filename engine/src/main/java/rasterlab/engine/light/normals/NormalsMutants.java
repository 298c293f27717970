package rasterlab.engine.light.normals;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.study.Mutant;

/** Normals of vertices with one mistake. */
final class NormalsMutants {
    private NormalsMutants() {}

    /**
     * Mutants of what is asked for.
     *
     * @param right the method without the mistakes
     */
    static List<Mutant<VertexNormals>> of(VertexNormals right) {
        return List.of(
                new Mutant<>(
                        "equal-weights", "cube-cut-one-way", new WeightedNormals(Weight.PLAIN)),
                new Mutant<>(
                        "area-weights", "roof-with-a-long-side", new WeightedNormals(Weight.AREA)),
                new Mutant<>(
                        "inwards",
                        "to-the-outside",
                        (vertices, triangles) -> {
                            double[] normals = right.normals(vertices, triangles);
                            for (int i = 0; i < normals.length; i++) normals[i] = -normals[i];
                            return normals;
                        }),
                new Mutant<>(
                        "no-area-spoils",
                        "zero-area-face",
                        (vertices, triangles) ->
                                spoiled(right.normals(vertices, triangles), vertices, triangles)),
                new Mutant<>(
                        "lone-vertex-gets-a-normal",
                        "vertex-without-a-face",
                        (vertices, triangles) -> {
                            double[] normals = right.normals(vertices, triangles);
                            for (int v = 0; v < normals.length / 3; v++)
                                if (hasNone(triangles, v)) normals[3 * v + 2] = 1;
                            return normals;
                        }),
                new Mutant<>(
                        "absolute-epsilon",
                        "tiny-faces",
                        (vertices, triangles) ->
                                Arrays.stream(vertices).allMatch(c -> Math.abs(c) < 1e-9)
                                        ? new double[vertices.length]
                                        : right.normals(vertices, triangles)),
                new Mutant<>(
                        "cancelled-normalized",
                        "both-sides-of-a-sheet",
                        (vertices, triangles) -> {
                            double[] normals = right.normals(vertices, triangles);
                            for (int v = 0; v < normals.length / 3; v++)
                                if (!hasNone(triangles, v) && isNothing(normals, v))
                                    Arrays.fill(normals, 3 * v, 3 * v + 3, Double.NaN);
                            return normals;
                        }),
                new Mutant<>(
                        "not-normalized",
                        "flat",
                        (vertices, triangles) -> sums(vertices, triangles, 1, 3)),
                new Mutant<>("mean-not-normalized", "to-the-outside", NormalsMutants::means),
                new Mutant<>(
                        "first-vertex-only",
                        "flat",
                        (vertices, triangles) -> normalized(sums(vertices, triangles, 1, 1))),
                new Mutant<>(
                        "last-face-decides",
                        "roof-with-a-long-side",
                        (vertices, triangles) -> normalized(sums(vertices, triangles, 0, 3))));
    }

    private static boolean hasNone(int[] triangles, int vertex) {
        return Arrays.stream(triangles).noneMatch(corner -> corner == vertex);
    }

    private static boolean isNothing(double[] normals, int v) {
        return normals[3 * v] == 0 && normals[3 * v + 1] == 0 && normals[3 * v + 2] == 0;
    }

    private static double[] spoiled(double[] normals, double[] vertices, int[] triangles) {
        for (int t = 0; t < triangles.length; t += 3)
            for (int k = 0; k < 3; k++)
                if (same(vertices, triangles[t + k], triangles[t + (k + 1) % 3]))
                    for (int c = t; c < t + 3; c++)
                        Arrays.fill(normals, 3 * triangles[c], 3 * triangles[c] + 3, Double.NaN);
        return normals;
    }

    private static boolean same(double[] vertices, int a, int b) {
        return vertices[3 * a] == vertices[3 * b]
                && vertices[3 * a + 1] == vertices[3 * b + 1]
                && vertices[3 * a + 2] == vertices[3 * b + 2];
    }

    /**
     * The sums of the faces' vectors at the vertices.
     *
     * @param kept 0 where a face replaces those before it
     * @param corners how many of a face's vertices it counts for
     */
    private static double[] sums(double[] v, int[] triangles, int kept, int corners) {
        var sums = new double[v.length];
        for (int t = 0; t < triangles.length; t += 3) {
            double[] c = vector(v, triangles[t], triangles[t + 1], triangles[t + 2]);
            for (int k = 0; k < corners; k++)
                for (int i = 0; i < 3; i++) {
                    int at = 3 * triangles[t + k] + i;
                    sums[at] = kept * sums[at] + c[i];
                }
        }
        return sums;
    }

    private static double[] vector(double[] v, int p, int q, int r) {
        var u = new double[3];
        var w = new double[3];
        for (int i = 0; i < 3; i++) {
            u[i] = v[3 * q + i] - v[3 * p + i];
            w[i] = v[3 * r + i] - v[3 * p + i];
        }
        return new double[] {
            u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]
        };
    }

    private static double[] means(double[] vertices, int[] triangles) {
        double[] sums = sums(vertices, triangles, 1, 3);
        var faces = new int[sums.length / 3];
        for (int corner : triangles) faces[corner]++;
        for (int i = 0; i < sums.length; i++) if (faces[i / 3] > 0) sums[i] /= faces[i / 3];
        return sums;
    }

    private static double[] normalized(double[] sums) {
        for (int i = 0; i < sums.length; i += 3) {
            double length = Math.hypot(sums[i], Math.hypot(sums[i + 1], sums[i + 2]));
            for (int c = i; c < i + 3; c++) sums[c] = length == 0 ? 0 : sums[c] / length;
        }
        return sums;
    }
}
