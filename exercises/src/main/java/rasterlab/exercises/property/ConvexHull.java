package rasterlab.exercises.property;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The convex hull of points, by A. M. Andrew's monotone chains.
 *
 * @param corners counter-clockwise where y grows up; one or two where the points are on a line
 */
record ConvexHull(List<double[]> corners) {
    static ConvexHull of(double[] x, double[] y) {
        List<double[]> sorted =
                IntStream.range(0, x.length)
                        .mapToObj(i -> new double[] {x[i], y[i]})
                        .sorted(
                                Comparator.<double[]>comparingDouble(p -> p[0])
                                        .thenComparingDouble(p -> p[1]))
                        .toList();
        List<double[]> hull = new ArrayList<>(chain(sorted));
        List<double[]> back = new ArrayList<>(sorted);
        Collections.reverse(back);
        hull.addAll(chain(back));
        return new ConvexHull(hull.isEmpty() ? List.of(sorted.get(0)) : hull);
    }

    /** One side of it, without the last corner, which begins the other. */
    private static List<double[]> chain(List<double[]> sorted) {
        List<double[]> chain = new ArrayList<>();
        for (double[] one : sorted) {
            while (chain.size() > 1
                    && turn(chain.get(chain.size() - 2), chain.get(chain.size() - 1), one) <= 0)
                chain.remove(chain.size() - 1);
            chain.add(one);
        }
        return chain.subList(0, chain.size() - 1);
    }

    private static double turn(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    /** The point of the hull next to that one: itself where it is inside. */
    double[] nearest(double x, double y) {
        double[] point = {x, y};
        double[] nearest = point;
        double least = Double.POSITIVE_INFINITY;
        boolean inside = corners.size() > 2;
        for (int i = 0; i < corners.size(); i++) {
            double[] from = corners.get(i);
            double[] to = corners.get((i + 1) % corners.size());
            if (!(turn(from, to, point) >= 0)) inside = false;
            double[] on = onSide(from, to, point);
            double apart = Math.hypot(on[0] - x, on[1] - y);
            if (apart < least) {
                least = apart;
                nearest = on;
            }
        }
        return inside ? point : nearest;
    }

    private static double[] onSide(double[] from, double[] to, double[] point) {
        double x = to[0] - from[0];
        double y = to[1] - from[1];
        double length = x * x + y * y;
        double along = (point[0] - from[0]) * x + (point[1] - from[1]) * y;
        double share = length > 0 ? Math.max(0, Math.min(1, along / length)) : 0;
        return new double[] {from[0] + share * x, from[1] + share * y};
    }
}
