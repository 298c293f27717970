package rasterlab.app.clip.outcome;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rasterlab.engine.clip.polygon.ConvexWindow;
import rasterlab.engine.clip.segment.ClipWindow;

/**
 * One side of a window or one plane of the view volume: a point is within where {@code normal ·
 * point + offset ≥ 0}.
 *
 * @param normal inward, one number for each dimension
 */
public record Border(double[] normal, double offset) {
    /** Index of an upright window's side by its name, as its corners go round. */
    static final Map<String, Integer> SIDES = Map.of("bottom", 0, "right", 1, "top", 2, "left", 3);

    /** Index of a plane by each name that a method has for it. */
    static final Map<String, Integer> PLANES =
            Map.ofEntries(
                    Map.entry("y = z", 0),
                    Map.entry("y = -z", 1),
                    Map.entry("x = z", 2),
                    Map.entry("x = -z", 3),
                    Map.entry("z = 1", 4),
                    Map.entry("z = zmin", 5),
                    Map.entry("Y = W", 0),
                    Map.entry("Y = -W", 1),
                    Map.entry("X = W", 2),
                    Map.entry("X = -W", 3),
                    Map.entry("Z = W", 4),
                    Map.entry("Z = 0", 5),
                    Map.entry("Y = 1", 0),
                    Map.entry("Y = -1", 1),
                    Map.entry("X = 1", 2),
                    Map.entry("X = -1", 3),
                    Map.entry("Z = 1", 4));

    /** Bottom, right, top and left. */
    static List<Border> of(ClipWindow window) {
        return List.of(
                border(-window.ymin(), 0, 1),
                border(window.xmax(), -1, 0),
                border(window.ymax(), 0, -1),
                border(-window.xmin(), 1, 0));
    }

    /**
     * The sides of a convex window, counter-clockwise as its methods take them.
     *
     * @throws IllegalArgumentException if it is not convex
     */
    static List<Border> convex(double[] corners) {
        var borders = new ArrayList<Border>();
        for (double[] edge : Edges.around(ConvexWindow.of(corners).xy())) {
            double normalX = edge[1] - edge[3];
            double normalY = edge[2] - edge[0];
            borders.add(border(-normalX * edge[0] - normalY * edge[1], normalX, normalY));
        }
        return borders;
    }

    /** The planes y = z, y = −z, x = z, x = −z, z = 1 and z = zmin. */
    static List<Border> volume(double zmin) {
        return List.of(
                border(0, 0, -1, 1),
                border(0, 0, 1, 1),
                border(0, -1, 0, 1),
                border(0, 1, 0, 1),
                border(1, 0, 0, -1),
                border(-zmin, 0, 0, 1));
    }

    private static Border border(double offset, double... normal) {
        return new Border(normal, offset);
    }

    /** The distance from the border in lengths of the normal, above 0 within. */
    public double distance(double[] ends, int end) {
        double sum = offset;
        for (int i = 0; i < normal.length; i++)
            if (normal[i] != 0) sum += normal[i] * ends[end * normal.length + i];
        return sum;
    }

    /** Which way a segment passes this border or its continuation. */
    ClipStep.Passing passing(double[] ends) {
        double from = distance(ends, 0);
        double to = distance(ends, 1);
        if (to > from) return ClipStep.Passing.ENTERING;
        return to < from ? ClipStep.Passing.LEAVING : ClipStep.Passing.NONE;
    }

    /** Where a segment meets this border, at t = d0/(d0 − d1); no place where t is not in 0..1. */
    public double[] meeting(double[] ends) {
        double from = distance(ends, 0);
        double t = from / (from - distance(ends, 1));
        return t >= 0 && t <= 1 ? at(ends, t) : new double[0];
    }

    /** The point at t on a segment. */
    static double[] at(double[] ends, double t) {
        int dimension = ends.length / 2;
        var point = new double[dimension];
        for (int i = 0; i < dimension; i++)
            point[i] = ends[i] + t * (ends[dimension + i] - ends[i]);
        return point;
    }
}
