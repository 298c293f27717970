package rasterlab.engine.sight;

import rasterlab.engine.scene.Mesh;

/**
 * The smallest distance in space between two faces of a mesh.
 *
 * <p>It is found among the triangles that fan out from each face's first corner: two of them are
 * nearest at a corner of one or on an edge of each, unless an edge of one passes through the other.
 * Pairs whose boxes are farther apart than the least so far are passed over.
 *
 * <p>Source of both distances: C. Ericson, Real-Time Collision Detection, 2005, sections 5.1.5 and
 * 5.1.9.
 */
final class FaceGaps {
    private final Mesh mesh;
    private final double[][] box;
    private double least = Double.POSITIVE_INFINITY;

    private FaceGaps(Mesh mesh) {
        this.mesh = mesh;
        box = new double[mesh.faceCount()][];
        for (int f = 0; f < box.length; f++) box[f] = box(f);
    }

    /** World units; infinite for one face, 0 where some touch or pass through each other. */
    static double least(Mesh mesh) {
        var gaps = new FaceGaps(mesh);
        for (int a = 0; a < gaps.box.length && gaps.least > 0; a++)
            for (int b = a + 1; b < gaps.box.length; b++)
                if (gaps.apart(a, b) < gaps.least) gaps.compare(a, b);
        return gaps.least;
    }

    private double[] box(int face) {
        double inf = Double.POSITIVE_INFINITY;
        double[] box = {inf, inf, inf, -inf, -inf, -inf};
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            double[] at = corner(face, k);
            for (int axis = 0; axis < 3; axis++) {
                box[axis] = Math.min(box[axis], at[axis]);
                box[3 + axis] = Math.max(box[3 + axis], at[axis]);
            }
        }
        return box;
    }

    private double apart(int a, int b) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = box[a][axis] - box[b][3 + axis];
            double gap = Math.max(0, Math.max(low, box[b][axis] - box[a][3 + axis]));
            square += gap * gap;
        }
        return Math.sqrt(square);
    }

    private double[] corner(int face, int k) {
        int v = mesh.corner(face, k % mesh.cornerCount(face));
        return new double[] {mesh.x(v), mesh.y(v), mesh.z(v)};
    }

    private void compare(int a, int b) {
        for (int i = 0; i < mesh.cornerCount(a); i++)
            for (int j = 0; j < mesh.cornerCount(b); j++)
                take(edges(corner(a, i), corner(a, i + 1), corner(b, j), corner(b, j + 1)));
        against(a, b);
        against(b, a);
    }

    /** The corners and edges of one face against the triangles of another. */
    private void against(int a, int b) {
        for (int fan = 1; fan + 1 < mesh.cornerCount(b); fan++) {
            double[][] triangle = {corner(b, 0), corner(b, fan), corner(b, fan + 1)};
            for (int i = 0; i < mesh.cornerCount(a); i++) {
                double[] p = corner(a, i);
                double[] q = corner(a, i + 1);
                double[] normal =
                        cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
                double length = Math.sqrt(dot(normal, normal));
                if (length == 0) continue;
                double from = dot(normal, minus(p, triangle[0])) / length;
                double to = dot(normal, minus(q, triangle[0])) / length;
                if (within(triangle, normal, p)) take(Math.abs(from));
                if (from * to > 0 || from == to) continue;
                double[] there = along(p, q, from / (from - to));
                if (within(triangle, normal, there)) take(0);
            }
        }
    }

    private void take(double distance) {
        least = Math.min(least, distance);
    }

    /** Whether the foot of a point on a triangle's plane is in it. */
    private static boolean within(double[][] triangle, double[] normal, double[] p) {
        for (int i = 0; i < 3; i++) {
            double[] edge = minus(triangle[(i + 1) % 3], triangle[i]);
            if (dot(cross(edge, minus(p, triangle[i])), normal) < 0) return false;
        }
        return true;
    }

    private static double edges(double[] p, double[] q, double[] r, double[] s) {
        double[] d = minus(q, p);
        double[] e = minus(s, r);
        double[] off = minus(p, r);
        double dd = dot(d, d);
        double ee = dot(e, e);
        double de = dot(d, e);
        double fromD = dot(d, off);
        double fromE = dot(e, off);
        double room = dd * ee - de * de;
        double t = room > 0 ? clamp((de * fromE - fromD * ee) / room) : 0;
        double u = ee > 0 ? (de * t + fromE) / ee : 0;
        if (u < 0 || u > 1) {
            u = clamp(u);
            t = dd > 0 ? clamp((de * u - fromD) / dd) : 0;
        }
        double[] apart = minus(along(p, q, t), along(r, s, u));
        return Math.sqrt(dot(apart, apart));
    }

    private static double clamp(double t) {
        return Math.max(0, Math.min(1, t));
    }

    private static double[] along(double[] p, double[] q, double t) {
        return new double[] {
            p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])
        };
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        };
    }
}
