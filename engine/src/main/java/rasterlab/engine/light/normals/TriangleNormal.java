package rasterlab.engine.light.normals;

import rasterlab.engine.light.UnitVector;

/** Normals and angles of one triangle. */
public final class TriangleNormal {
    private TriangleNormal() {}

    /**
     * Computes (b − a) × (c − a): along the outward normal, as long as twice the area.
     *
     * @param face where the face's three vertex numbers begin in {@code triangles}
     * @param out receives x, y, z
     */
    public static void cross(double[] vertices, int[] triangles, int face, double[] out) {
        int a = 3 * triangles[face];
        int b = 3 * triangles[face + 1];
        int c = 3 * triangles[face + 2];
        double px = vertices[b] - vertices[a];
        double py = vertices[b + 1] - vertices[a + 1];
        double pz = vertices[b + 2] - vertices[a + 2];
        double qx = vertices[c] - vertices[a];
        double qy = vertices[c + 1] - vertices[a + 1];
        double qz = vertices[c + 2] - vertices[a + 2];
        out[0] = py * qz - pz * qy;
        out[1] = pz * qx - px * qz;
        out[2] = px * qy - py * qx;
    }

    /**
     * Computes the same direction from edges brought to length 1 first: no product vanishes,
     * however small the triangle is.
     */
    static void direction(double[] vertices, int[] triangles, int face, double[] out) {
        int a = 3 * triangles[face];
        double[] p = edge(vertices, a, 3 * triangles[face + 1]);
        double[] q = edge(vertices, a, 3 * triangles[face + 2]);
        UnitVector.normalize(p);
        UnitVector.normalize(q);
        out[0] = p[1] * q[2] - p[2] * q[1];
        out[1] = p[2] * q[0] - p[0] * q[2];
        out[2] = p[0] * q[1] - p[1] * q[0];
    }

    /**
     * The angle at a corner in radians, 0 to π: atan2(|p × q|, p·q) of the two edges from it, which
     * unlike an arc cosine keeps its digits close to 0 and π.
     */
    static double angle(double[] vertices, int[] triangles, int face, int corner) {
        int a = 3 * triangles[face + corner];
        double[] p = edge(vertices, a, 3 * triangles[face + (corner + 1) % 3]);
        double[] q = edge(vertices, a, 3 * triangles[face + (corner + 2) % 3]);
        UnitVector.normalize(p);
        UnitVector.normalize(q);
        double[] cross = {
            p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]
        };
        double dot = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
        return Math.atan2(UnitVector.length(cross), dot);
    }

    private static double[] edge(double[] vertices, int from, int to) {
        return new double[] {
            vertices[to] - vertices[from],
            vertices[to + 1] - vertices[from + 1],
            vertices[to + 2] - vertices[from + 2]
        };
    }
}
