package rasterlab.engine.spline.curve;

import java.util.Arrays;
import java.util.Comparator;

/**
 * The convex hull of points: what no mean of them leaves, and so no span of a Bézier curve or a
 * B-spline.
 *
 * <p>Sorted by x and y, the lower and the upper chain each keep only points that turn one way.
 * Source: A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, Information
 * Processing Letters 9(5), 1979.
 */
public final class ControlHull {
    private ControlHull() {}

    /**
     * The corners in order around the hull, none of them between two others; a single point or the
     * two ends where all points lie on one line.
     *
     * @param x at least one finite coordinate
     * @param y as many
     * @return indices of points
     */
    public static int[] of(double[] x, double[] y) {
        if (x.length == 0 || x.length != y.length)
            throw new IllegalArgumentException(
                    "points: needs at least one, and as many y as x, got %d and %d"
                            .formatted(x.length, y.length));
        Integer[] order = new Integer[x.length];
        Arrays.setAll(order, i -> i);
        Comparator<Integer> byX = Comparator.comparingDouble(i -> x[i]);
        Arrays.sort(order, byX.thenComparingDouble(i -> y[i]));
        var hull = new int[2 * x.length];
        int size = 0;
        for (int i = 0; i < order.length; i++) size = added(hull, size, 0, order[i], x, y);
        int chain = size - 1;
        for (int i = order.length - 2; i >= 0; i--) size = added(hull, size, chain, order[i], x, y);
        return Arrays.copyOf(hull, Math.max(1, size - 1));
    }

    /** Takes back the points after {@code from} that the new one makes needless, then adds it. */
    private static int added(int[] hull, int size, int from, int point, double[] x, double[] y) {
        int kept = size;
        while (kept >= from + 2 && !turns(x, y, hull[kept - 2], hull[kept - 1], point)) kept--;
        boolean again = kept > 0 && x[hull[kept - 1]] == x[point] && y[hull[kept - 1]] == y[point];
        if (again) return kept;
        hull[kept] = point;
        return kept + 1;
    }

    private static boolean turns(double[] x, double[] y, int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]) > 0;
    }
}
