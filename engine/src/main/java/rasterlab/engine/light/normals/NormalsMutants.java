package rasterlab.engine.light.normals;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.study.Mutant;

/** Normals of vertices with one mistake. */
final class NormalsMutants {
    private static final VertexNormals RIGHT = new WeightedNormals(Weight.ANGLE);

    private NormalsMutants() {}

    static List<Mutant<VertexNormals>> all() {
        return List.of(
                new Mutant<>(
                        "equal-weights", "cube-cut-one-way", new WeightedNormals(Weight.PLAIN)),
                new Mutant<>(
                        "area-weights", "roof-with-a-long-side", new WeightedNormals(Weight.AREA)),
                new Mutant<>(
                        "inwards",
                        "to-the-outside",
                        (vertices, triangles) -> {
                            double[] normals = RIGHT.normals(vertices, triangles);
                            for (int i = 0; i < normals.length; i++) normals[i] = -normals[i];
                            return normals;
                        }),
                new Mutant<>("no-area-spoils", "zero-area-face", NormalsMutants::spoiled),
                new Mutant<>(
                        "lone-vertex-gets-a-normal",
                        "vertex-without-a-face",
                        (vertices, triangles) -> {
                            double[] normals = RIGHT.normals(vertices, triangles);
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
                                        : RIGHT.normals(vertices, triangles)),
                new Mutant<>(
                        "cancelled-normalized",
                        "both-sides-of-a-sheet",
                        (vertices, triangles) -> {
                            double[] normals = RIGHT.normals(vertices, triangles);
                            for (int v = 0; v < normals.length / 3; v++)
                                if (!hasNone(triangles, v) && isNothing(normals, v))
                                    Arrays.fill(normals, 3 * v, 3 * v + 3, Double.NaN);
                            return normals;
                        }));
    }

    private static boolean hasNone(int[] triangles, int vertex) {
        return Arrays.stream(triangles).noneMatch(corner -> corner == vertex);
    }

    private static boolean isNothing(double[] normals, int v) {
        return normals[3 * v] == 0 && normals[3 * v + 1] == 0 && normals[3 * v + 2] == 0;
    }

    private static double[] spoiled(double[] vertices, int[] triangles) {
        double[] normals = RIGHT.normals(vertices, triangles);
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
}
