package rasterlab.app.clip.outcome;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Straight edges in any number of dimensions, each as the coordinates of its first end, then of its
 * second; one whose ends are the same is a point.
 */
public final class Edges {
    private Edges() {}

    /** The edges of a closed polygon. */
    public static List<double[]> around(double[] xy) {
        var edges = new ArrayList<double[]>();
        for (int i = 0; i < xy.length; i += 2) {
            int next = (i + 2) % xy.length;
            edges.add(new double[] {xy[i], xy[i + 1], xy[next], xy[next + 1]});
        }
        return edges;
    }

    /**
     * The stretches of edges that none of the others covers.
     *
     * @param tolerance distance at which two edges are the same
     */
    static List<double[]> minus(List<double[]> edges, List<double[]> others, double tolerance) {
        var rest = new ArrayList<double[]>();
        for (double[] edge : edges) {
            List<double[]> uncovered = List.of(edge);
            for (double[] other : others) uncovered = cut(uncovered, other, tolerance);
            rest.addAll(uncovered);
        }
        return rest;
    }

    private static List<double[]> cut(List<double[]> edges, double[] other, double tolerance) {
        var rest = new ArrayList<double[]>();
        for (double[] edge : edges) rest.addAll(cut(edge, other, tolerance));
        return rest;
    }

    /**
     * Cuts an edge e(s) = from + s·(to − from) where the other covers it: that one's ends are at s
     * = ((p − from)·(to − from))/|to − from|², and it covers what lies between where both are on
     * the line.
     */
    private static List<double[]> cut(double[] edge, double[] other, double tolerance) {
        double length = distance(edge, 0, edge, edge.length / 2);
        if (length <= tolerance)
            return distanceFrom(other, edge) <= tolerance ? List.of() : List.of(edge);
        double s0 = share(edge, other, 0);
        double s1 = share(edge, other, other.length / 2);
        double low = Math.min(s0, s1);
        double high = Math.max(s0, s1);
        double least = tolerance / length;
        if (isOff(edge, s0, other, 0, tolerance)
                || isOff(edge, s1, other, other.length / 2, tolerance)
                || high <= least
                || low >= 1 - least
                || high - low <= least) return List.of(edge);
        var rest = new ArrayList<double[]>();
        if (low > least) rest.add(stretch(edge, 0, low));
        if (high < 1 - least) rest.add(stretch(edge, high, 1));
        return rest;
    }

    private static boolean isOff(
            double[] edge, double s, double[] other, int end, double tolerance) {
        return !(distance(at(edge, s), 0, other, end) <= tolerance);
    }

    /** Distance of a point from the nearest point of an edge. */
    private static double distanceFrom(double[] edge, double[] point) {
        double length = distance(edge, 0, edge, edge.length / 2);
        double s = length == 0 ? 0 : Math.max(0, Math.min(1, share(edge, point, 0)));
        return distance(at(edge, s), 0, point, 0);
    }

    private static double share(double[] edge, double[] other, int end) {
        int dimension = edge.length / 2;
        double along = 0;
        double square = 0;
        for (int i = 0; i < dimension; i++) {
            double way = edge[dimension + i] - edge[i];
            along += (other[end + i] - edge[i]) * way;
            square += way * way;
        }
        return along / square;
    }

    private static double[] at(double[] edge, double s) {
        int dimension = edge.length / 2;
        var point = new double[dimension];
        for (int i = 0; i < dimension; i++)
            point[i] = edge[i] + s * (edge[dimension + i] - edge[i]);
        return point;
    }

    private static double[] stretch(double[] edge, double from, double to) {
        int dimension = edge.length / 2;
        double[] both = Arrays.copyOf(at(edge, from), edge.length);
        System.arraycopy(at(edge, to), 0, both, dimension, dimension);
        return both;
    }

    /**
     * The distance between two points that begin at {@code i} and {@code j}, in as many dimensions
     * as a.
     */
    private static double distance(double[] a, int i, double[] b, int j) {
        int dimension = Math.min(a.length - i, b.length - j);
        double square = 0;
        for (int k = 0; k < dimension; k++) square += (a[i + k] - b[j + k]) * (a[i + k] - b[j + k]);
        return Math.sqrt(square);
    }
}
