package rasterlab.engine.visibility.order;

/** A polygon laid flat: its own corner 0 at the origin, its size 1, its normal n along z. */
final class FlatPolygon {
    private final double[] origin;
    private final double size;
    private final double[] normal = new double[3];
    private final double[] given;

    FlatPolygon(double[] given) {
        this.given = given;
        origin = new double[] {given[0], given[1], given[2]};
        double most = 0;
        for (int i = 3; i < given.length; i++)
            most = Math.max(most, Math.abs(given[i] - origin[i % 3]));
        size = most;
        double[] sum = twiceArea(given);
        double length = Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        for (int axis = 0; axis < 3; axis++) normal[axis] = sum[axis] / length;
    }

    /** Coordinate of a corner, less corner 0 of the polygon, over its size. */
    private double at(double[] xyz, int corner, int axis) {
        return (xyz[3 * corner + axis] - origin[axis]) / size;
    }

    private double[] twiceArea(double[] xyz) {
        var sum = new double[3];
        for (int i = 1; i + 1 < xyz.length / 3; i++) {
            double[] cross = cross(edge(xyz, 0, xyz, i), edge(xyz, 0, xyz, i + 1));
            for (int axis = 0; axis < 3; axis++) sum[axis] += cross[axis];
        }
        return sum;
    }

    /** Area over the square of the size, negative if it goes round the other way. */
    double area(double[] xyz) {
        return dot(normal, twiceArea(xyz)) / 2;
    }

    /** Whether a piece lies in the polygon but for {@code allowed} of its size. */
    boolean holds(double[] piece, double allowed) {
        for (int i = 0; i < piece.length / 3; i++) {
            if (Math.abs(dot(normal, edge(given, 0, piece, i))) > allowed) return false;
            for (int k = 0; k < given.length / 3; k++)
                if (inward(given, k, piece, i) < -allowed) return false;
        }
        return true;
    }

    /** Whether an edge of one of two pieces has the other on its outer side. */
    boolean apart(double[] one, double[] other, double allowed) {
        return edgeParts(one, other, allowed) || edgeParts(other, one, allowed);
    }

    private boolean edgeParts(double[] one, double[] other, double allowed) {
        for (int k = 0; k < one.length / 3; k++) {
            double most = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < other.length / 3; i++)
                most = Math.max(most, inward(one, k, other, i));
            if (most <= allowed && length(one, k) > 0) return true;
        }
        return false;
    }

    private double length(double[] xyz, int edge) {
        double[] along = edge(xyz, edge, xyz, (edge + 1) % (xyz.length / 3));
        return Math.sqrt(dot(along, along));
    }

    /** How far inside of the line along an edge a corner lies; 0 for an edge without length. */
    private double inward(double[] xyz, int edge, double[] other, int corner) {
        double[] along = edge(xyz, edge, xyz, (edge + 1) % (xyz.length / 3));
        double length = Math.sqrt(dot(along, along));
        if (length == 0) return 0;
        return dot(cross(normal, along), edge(xyz, edge, other, corner)) / length;
    }

    private double[] edge(double[] from, int i, double[] to, int j) {
        var edge = new double[3];
        for (int axis = 0; axis < 3; axis++) edge[axis] = at(to, j, axis) - at(from, i, axis);
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
