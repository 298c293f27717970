package rasterlab.engine.visibility.order;

import java.util.List;

/**
 * The look from the eye to the middle of the box round all polygons, and two directions across it.
 *
 * <p>Depth z grows away from the eye; x and y across it make a right angle with it and each other.
 */
final class EyeFrame {
    private final double[] across;
    private final double[] up;
    private final double[] look;
    private final double distance;

    /**
     * @throws IllegalArgumentException if the eye is in the middle, so that it has no direction
     */
    EyeFrame(List<Facet> facets) {
        var middle = middle(facets);
        distance = length(middle);
        if (distance == 0 && !facets.isEmpty())
            throw new IllegalArgumentException(
                    "eye must not be in the middle of the box round all polygons, where it has no"
                            + " direction to look");
        look = facets.isEmpty() ? new double[] {0, 0, 1} : unit(middle);
        int least = 0;
        for (int axis = 1; axis < 3; axis++)
            if (Math.abs(look[axis]) < Math.abs(look[least])) least = axis;
        var other = new double[3];
        other[least] = 1;
        across = unit(cross(look, other));
        up = cross(across, look);
    }

    private static double[] middle(List<Facet> facets) {
        var middle = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (Facet facet : facets)
                for (int i = axis; i < facet.seen().length; i += 3) {
                    least = Math.min(least, facet.seen()[i]);
                    most = Math.max(most, facet.seen()[i]);
                }
            middle[axis] = (least + most) / 2;
        }
        return middle;
    }

    /** Distance from the eye to the middle, in seen units. */
    double distance() {
        return distance;
    }

    double x(double[] seen, int corner) {
        return dot(across, seen, corner);
    }

    double y(double[] seen, int corner) {
        return dot(up, seen, corner);
    }

    double z(double[] seen, int corner) {
        return dot(look, seen, corner);
    }

    private static double dot(double[] direction, double[] seen, int corner) {
        return direction[0] * seen[3 * corner]
                + direction[1] * seen[3 * corner + 1]
                + direction[2] * seen[3 * corner + 2];
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        };
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }

    private static double[] unit(double[] v) {
        double length = length(v);
        return new double[] {v[0] / length, v[1] / length, v[2] / length};
    }
}
