package rasterlab.engine.scene;

import java.util.Arrays;
import rasterlab.engine.geometry.VertexNumber;

/** The rules a {@link Mesh} keeps, with messages that name the place that breaks one. */
final class MeshCheck {
    private static final double TOLERANCE = Mesh.TOLERANCE;

    private final double[] xyz;

    private MeshCheck(double[] xyz) {
        this.xyz = xyz;
    }

    /** Checks everything and returns the faces' unit normals as x, y, z triples. */
    static double[] normals(double[] xyz, int[][] faces) {
        var check = new MeshCheck(xyz);
        check.vertices();
        double[] normals = new double[3 * faces.length];
        for (int f = 0; f < faces.length; f++) {
            check.corners(f, faces[f]);
            double[] normal = check.normal(f, faces[f]);
            if (faces[f].length > 3) {
                check.flat(f, faces[f], normal);
                check.convex(f, check.apart(faces[f]), normal);
            }
            System.arraycopy(normal, 0, normals, 3 * f, 3);
        }
        return normals;
    }

    static void cornerNormals(double[] xyz, int corners) {
        requireCount("normals", 3, xyz.length, corners);
        for (int i = 0; i < xyz.length; i += 3) {
            double length =
                    Math.sqrt(xyz[i] * xyz[i] + xyz[i + 1] * xyz[i + 1] + xyz[i + 2] * xyz[i + 2]);
            if (!(Math.abs(length - 1) <= TOLERANCE))
                throw new IllegalArgumentException(
                        "corner %d: normal (%s, %s, %s) must have length 1, got %s"
                                .formatted(i / 3, xyz[i], xyz[i + 1], xyz[i + 2], length));
        }
    }

    static void cornerTexture(double[] st, int corners) {
        requireCount("texture coordinates", 2, st.length, corners);
        for (int i = 0; i < st.length; i++)
            if (!Double.isFinite(st[i]))
                throw new IllegalArgumentException(
                        "corner %d: %s must be finite, got %s"
                                .formatted(i / 2, i % 2 == 0 ? "s" : "t", st[i]));
    }

    static void cornerColors(double[] rgb, int corners) {
        requireCount("colours", 3, rgb.length, corners);
        for (int i = 0; i < rgb.length; i++)
            if (!(rgb[i] >= 0 && rgb[i] <= 1))
                throw new IllegalArgumentException(
                        "corner %d: colour (%s, %s, %s) must have shares from 0 to 1"
                                .formatted(
                                        i / 3,
                                        rgb[i - i % 3],
                                        rgb[i - i % 3 + 1],
                                        rgb[i - i % 3 + 2]));
    }

    private static void requireCount(String what, int each, int got, int corners) {
        if (got != each * corners)
            throw new IllegalArgumentException(
                    "%s need %d numbers for each of %d corners, got %d in all"
                            .formatted(what, each, corners, got));
    }

    private void vertices() {
        if (xyz.length % 3 != 0)
            throw new IllegalArgumentException(
                    "vertices must have 3 numbers each, got " + xyz.length + " in all");
        for (int i = 0; i < xyz.length; i++)
            if (!Double.isFinite(xyz[i]))
                throw new IllegalArgumentException(
                        "vertex %d: %s must be finite, got %s"
                                .formatted(i / 3, "xyz".charAt(i % 3), xyz[i]));
    }

    private void corners(int face, int[] corners) {
        int vertices = xyz.length / 3;
        for (int corner : corners)
            if (!VertexNumber.exists(corner, vertices))
                throw new IllegalArgumentException(
                        VertexNumber.refusal("face " + face + ": corner", corner, vertices));
        if (!threeDiffer(corners))
            throw new IllegalArgumentException(
                    "face %d: at least 3 different corners are needed, got %s"
                            .formatted(face, Arrays.toString(corners)));
    }

    private static boolean threeDiffer(int[] corners) {
        int second = -1;
        for (int corner : corners) {
            if (corner == corners[0] || corner == second) continue;
            if (second >= 0) return true;
            second = corner;
        }
        return false;
    }

    /**
     * The sum of the fan's cross products, which is twice the polygon's vector area whatever corner
     * the fan begins at, scaled to length 1. Large faces are measured in a larger unit, a power of
     * two, in which the square of an area stays finite.
     */
    private double[] normal(int face, int[] corners) {
        double longest = longestDiagonal(corners);
        double perUnit = Math.scalb(1.0, -Math.max(0, Math.getExponent(longest) / 2));
        double[] sum = vectorArea(corners, perUnit);
        double length = Math.sqrt(dot(sum, sum));
        if (!(length > TOLERANCE * (longest * perUnit * perUnit)))
            throw new IllegalArgumentException(
                    "face %d: corners %s span no area".formatted(face, Arrays.toString(corners)));
        for (int i = 0; i < 3; i++) sum[i] /= length;
        return sum;
    }

    private double[] vectorArea(int[] corners, double perUnit) {
        double[] sum = new double[3];
        for (int k = 1; k + 1 < corners.length; k++) {
            double[] cross =
                    cross(
                            scaled(edge(corners[0], corners[k]), perUnit),
                            scaled(edge(corners[0], corners[k + 1]), perUnit));
            for (int i = 0; i < 3; i++) sum[i] += cross[i];
        }
        return sum;
    }

    private static double[] scaled(double[] edge, double perUnit) {
        for (int i = 0; i < 3; i++) edge[i] *= perUnit;
        return edge;
    }

    /** The square of the longest way from the first corner to another. */
    private double longestDiagonal(int[] corners) {
        double longest = 0;
        for (int k = 1; k < corners.length; k++) {
            double[] edge = edge(corners[0], corners[k]);
            longest = Math.max(longest, dot(edge, edge));
        }
        return longest;
    }

    private void flat(int face, int[] corners, double[] normal) {
        for (int corner : corners) {
            double[] fromFirst = edge(corners[0], corner);
            if (Math.abs(dot(normal, fromFirst)) > TOLERANCE * Math.sqrt(dot(fromFirst, fromFirst)))
                throw new IllegalArgumentException(
                        "face %d: corner %d lies off the plane of the others"
                                .formatted(face, corner));
        }
    }

    /**
     * A polygon is convex when it turns to the left only, and once round in all: a pentagram and a
     * square listed twice turn to the left only, but twice round. Four corners that turn by less
     * than half a turn each cannot go round twice.
     */
    private void convex(int face, int[] corners, double[] normal) {
        double turned = 0;
        for (int k = 0; k < corners.length; k++) {
            double[] in = edge(corners[k], corners[(k + 1) % corners.length]);
            double[] out =
                    edge(corners[(k + 1) % corners.length], corners[(k + 2) % corners.length]);
            double left = dot(cross(in, out), normal);
            if (left < -TOLERANCE * Math.sqrt(dot(in, in) * dot(out, out)))
                throw new IllegalArgumentException(
                        "face %d: corner %d turns inwards, faces must be convex"
                                .formatted(face, corners[(k + 1) % corners.length]));
            if (corners.length > 4) turned += Math.atan2(left, dot(in, out));
        }
        if (corners.length <= 4) return;
        long rounds = Math.round(turned / (2 * Math.PI));
        if (rounds != 1)
            throw new IllegalArgumentException(
                    "face %d: corners %s go round %d times, faces must be convex"
                            .formatted(face, Arrays.toString(corners), rounds));
    }

    /** The corners without those that lie where the next one does. */
    private int[] apart(int[] corners) {
        int[] apart = new int[corners.length];
        int count = 0;
        for (int k = 0; k < corners.length; k++) {
            double[] next = edge(corners[k], corners[(k + 1) % corners.length]);
            if (dot(next, next) > 0) apart[count++] = corners[k];
        }
        return count == corners.length ? corners : Arrays.copyOf(apart, count);
    }

    private double[] edge(int from, int to) {
        double[] edge = new double[3];
        for (int i = 0; i < 3; i++) edge[i] = xyz[3 * to + i] - xyz[3 * from + i];
        return edge;
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        };
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
