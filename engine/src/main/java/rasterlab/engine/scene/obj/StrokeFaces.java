package rasterlab.engine.scene.obj;

/**
 * Makes thin bodies of lines and points, so that every method that draws faces draws them: a prism
 * of three sides about a line, an octahedron about a point.
 */
final class StrokeFaces {
    /** The faces of one line or point. */
    static final int MOST_TRIANGLES = 8;

    /** World units, where a model's radius is {@link Fit#RADIUS}. */
    static final double RADIUS = 0.8;

    private static final double POINT_RADIUS = 2 * RADIUS;

    /** Corners on the axes x, −x, y, −y, z, −z. */
    private static final int[][] OCTAHEDRON = {
        {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}
    };

    private static final int[][] PRISM = {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};

    private StrokeFaces() {}

    /** Corners of a body, x, y, z of each, and its faces by their numbers. */
    record StrokeBody(double[] xyz, int[][] faces) {
        /** The share that a line's second end has of a corner's colour. */
        double share(int corner) {
            if (faces != PRISM) return 0.5;
            return corner < 3 ? 0 : 1;
        }
    }

    /** A line that is as short as it is thick is a point. */
    static StrokeBody between(double[] from, double[] to) {
        double[] along = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        double length = length(along);
        return length < RADIUS ? point(from) : line(from, to, along, length);
    }

    private static StrokeBody point(double[] at) {
        double[] xyz = new double[18];
        for (int corner = 0; corner < 6; corner++) {
            System.arraycopy(at, 0, xyz, 3 * corner, 3);
            xyz[3 * corner + corner / 2] += corner % 2 == 0 ? POINT_RADIUS : -POINT_RADIUS;
        }
        return new StrokeBody(xyz, OCTAHEDRON);
    }

    private static StrokeBody line(double[] from, double[] to, double[] along, double length) {
        int least = 0;
        for (int axis = 1; axis < 3; axis++)
            if (Math.abs(along[axis]) < Math.abs(along[least])) least = axis;
        double[] axis = new double[3];
        axis[least] = 1;
        double[] u = cross(axis, along);
        double thick = length(u);
        for (int i = 0; i < 3; i++) u[i] /= thick;
        double[] v = cross(along, u);
        for (int i = 0; i < 3; i++) v[i] /= length;
        double[] xyz = new double[18];
        for (int k = 0; k < 3; k++) {
            double cos = RADIUS * Math.cos(2 * Math.PI * k / 3);
            double sin = RADIUS * Math.sin(2 * Math.PI * k / 3);
            for (int i = 0; i < 3; i++) {
                double off = cos * u[i] + sin * v[i];
                xyz[3 * k + i] = from[i] + off;
                xyz[3 * (k + 3) + i] = to[i] + off;
            }
        }
        return new StrokeBody(xyz, PRISM);
    }

    /** The outward normal of a body's face, of length 1. */
    static double[] normal(double[] xyz, int[] face) {
        double[][] edge = new double[2][3];
        for (int e = 0; e < 2; e++)
            for (int i = 0; i < 3; i++)
                edge[e][i] = xyz[3 * face[e + 1] + i] - xyz[3 * face[0] + i];
        double[] normal = cross(edge[0], edge[1]);
        double length = length(normal);
        for (int i = 0; i < 3; i++) normal[i] /= length;
        return normal;
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        };
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
}
