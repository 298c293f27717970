package rasterlab.engine.border;

import rasterlab.contract.VertexNormals;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.normals.TriangleSurface;

/** Small surfaces whose faces are no slivers and do not cancel out, as the method's text says. */
final class NormalsBorders {
    private static final double LEAST = 1e-3;
    private static final double LARGEST_UNIT = VertexNormals.LARGEST / 9;

    private NormalsBorders() {}

    static Border<?, ?, ?> all() {
        return Border.of(new NormalsTopic(), NormalsBorders::surface).slow(0.3);
    }

    private static TriangleSurface surface(Draws draws) {
        int vertices = 3 + draws.pick(3);
        var xyz = new double[3 * vertices];
        double unit = draws.coin() ? 1 : draws.number(Double.MIN_VALUE, LARGEST_UNIT);
        for (int i = 0; i < xyz.length; i++)
            xyz[i] =
                    draws.pick(4) < 3
                            ? unit * draws.whole(-9, 9)
                            : draws.number(-VertexNormals.LARGEST, VertexNormals.LARGEST);
        var corners = new int[3 * (1 + draws.pick(3))];
        for (int i = 0; i < corners.length; i += 3) {
            corners[i] = draws.pick(vertices);
            corners[i + 1] = (corners[i] + 1) % vertices;
            corners[i + 2] = (corners[i] + 2) % vertices;
        }
        requireClear(xyz, corners);
        return new TriangleSurface(xyz, corners);
    }

    /** Passes where every face has corners apart and vertices have a say that is left. */
    private static void requireClear(double[] xyz, int[] corners) {
        var sums = new double[xyz.length];
        var weights = new double[xyz.length / 3];
        for (int face = 0; face < corners.length; face += 3)
            for (int k = 0; k < 3; k++) {
                int vertex = corners[face + k];
                double[] p = edge(xyz, vertex, corners[face + (k + 1) % 3]);
                double[] q = edge(xyz, vertex, corners[face + (k + 2) % 3]);
                double[] normal = {
                    p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]
                };
                double sine = UnitVector.length(normal);
                if (sine < LEAST) throw new IllegalArgumentException("a sliver");
                double angle = Math.atan2(sine, p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
                weights[vertex] += angle;
                for (int c = 0; c < 3; c++) sums[3 * vertex + c] += angle * normal[c] / sine;
            }
        for (int v = 0; v < weights.length; v++) {
            double[] sum = {sums[3 * v], sums[3 * v + 1], sums[3 * v + 2]};
            if (UnitVector.length(sum) < LEAST * weights[v])
                throw new IllegalArgumentException("faces cancel out");
        }
    }

    /** The unit vector from one vertex to another that is clearly elsewhere. */
    private static double[] edge(double[] xyz, int from, int to) {
        var edge = new double[3];
        double largest = 0;
        for (int c = 0; c < 3; c++) {
            edge[c] = xyz[3 * to + c] - xyz[3 * from + c];
            largest = Math.max(largest, Math.abs(xyz[3 * to + c]));
            largest = Math.max(largest, Math.abs(xyz[3 * from + c]));
        }
        double length = UnitVector.length(edge);
        if (length == 0 || length < LEAST * largest)
            throw new IllegalArgumentException("corners too close to each other");
        UnitVector.normalize(edge);
        return edge;
    }
}
