package rasterlab.engine.visibility.order;

/** A flat convex polygon, measured from an eye at the origin. */
final class SeenOutline {
    private final double[] seen;
    private final int corners;
    private final double[] normal = new double[3];
    private final double width;

    /**
     * @param seen x, y, z of the corners, of middling size
     */
    SeenOutline(double[] seen) {
        this.seen = seen;
        corners = seen.length / 3;
        for (int i = 1; i + 1 < corners; i++) {
            double[] cross = cross(between(0, i), between(0, i + 1));
            for (int axis = 0; axis < 3; axis++) normal[axis] += cross[axis];
        }
        double twiceArea = length(normal);
        for (int axis = 0; axis < 3; axis++) normal[axis] /= twiceArea;
        width = twiceArea / 2 / longest();
    }

    /** The area by the longest way between corners; not above 0 if there is no area. */
    double width() {
        return width;
    }

    private double longest() {
        double longest = 0;
        for (int i = 1; i < corners; i++)
            for (int k = 0; k < i; k++) longest = Math.max(longest, length(between(k, i)));
        return longest;
    }

    /** The distance from the eye to the nearest point of the polygon. */
    double distance() {
        boolean over = true;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < corners; i++) {
            double[] along = between(i, (i + 1) % corners);
            over &= dot(cross(corner(i), along), normal) >= 0;
            least = Math.min(least, toEdge(i, along));
        }
        return over ? Math.abs(dot(normal, corner(0))) : least;
    }

    private double toEdge(int i, double[] along) {
        double[] nearest = corner(i);
        double square = dot(along, along);
        double t = square == 0 ? 0 : Math.max(0, Math.min(1, -dot(nearest, along) / square));
        for (int axis = 0; axis < 3; axis++) nearest[axis] += t * along[axis];
        return length(nearest);
    }

    private double[] corner(int i) {
        return new double[] {seen[3 * i], seen[3 * i + 1], seen[3 * i + 2]};
    }

    private double[] between(int i, int k) {
        return new double[] {
            seen[3 * k] - seen[3 * i],
            seen[3 * k + 1] - seen[3 * i + 1],
            seen[3 * k + 2] - seen[3 * i + 2]
        };
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        };
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double length(double[] a) {
        return Math.sqrt(dot(a, a));
    }
}
