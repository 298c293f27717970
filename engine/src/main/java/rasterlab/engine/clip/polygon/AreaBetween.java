package rasterlab.engine.clip.polygon;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.TreeSet;

/**
 * The area that only one of two sets of polygons covers.
 *
 * <p>All edges of both together, filled by the even-odd rule, are that area. Edges that both have
 * are struck out; level lines through the ends and, of up to {@value #MOST_CROSSED}, the crossings
 * of the rest cut the area into trapezoids, whose middles are added up.
 */
final class AreaBetween {
    /**
     * The number of different edges up to which crossings are looked for; beyond it that would take
     * too long, and a trapezoid in which edges cross is measured at its middle all the same.
     */
    private static final int MOST_CROSSED = 300;

    private final List<double[]> edges = new ArrayList<>();

    private AreaBetween() {}

    static double of(List<double[]> polygons, List<double[]> others) {
        var between = new AreaBetween();
        var counts = new HashMap<List<Double>, Integer>();
        for (var group : List.of(polygons, others))
            for (double[] xy : group)
                for (int i = 0; i < xy.length; i += 2) {
                    int j = (i + 2) % xy.length;
                    counts.merge(upward(xy[i], xy[i + 1], xy[j], xy[j + 1]), 1, Integer::sum);
                }
        counts.forEach((edge, count) -> between.add(edge, count));
        return between.area();
    }

    /** The edge's ends from the lower to the upper one, −0.0 written as 0.0. */
    private static List<Double> upward(double x0, double y0, double x1, double y1) {
        boolean swap = y0 > y1 || y0 == y1 && x0 > x1;
        return swap
                ? List.of(x1 + 0.0, y1 + 0.0, x0 + 0.0, y0 + 0.0)
                : List.of(x0 + 0.0, y0 + 0.0, x1 + 0.0, y1 + 0.0);
    }

    private void add(List<Double> edge, int count) {
        boolean level = edge.get(1).equals(edge.get(3));
        if (count % 2 != 0 && !level)
            edges.add(edge.stream().mapToDouble(Double::doubleValue).toArray());
    }

    private double area() {
        var levels = new TreeSet<Double>();
        for (double[] edge : edges) {
            levels.add(edge[1]);
            levels.add(edge[3]);
        }
        if (edges.size() <= MOST_CROSSED) addCrossings(levels);
        double area = 0;
        Double low = null;
        for (double high : levels) {
            if (low != null) area += slab(low, high);
            low = high;
        }
        return area;
    }

    private void addCrossings(TreeSet<Double> levels) {
        for (int i = 0; i < edges.size(); i++)
            for (int j = 0; j < i; j++) {
                double[] a = edges.get(i);
                double[] b = edges.get(j);
                double low = Math.max(a[1], b[1]);
                double high = Math.min(a[3], b[3]);
                if (!(low < high)) continue;
                double below = x(a, low) - x(b, low);
                double above = x(a, high) - x(b, high);
                if (below * above < 0) levels.add(low + (high - low) * below / (below - above));
            }
    }

    private double slab(double low, double high) {
        double middle = low + (high - low) / 2;
        double[] crossings =
                edges.stream()
                        .filter(edge -> edge[1] <= low && edge[3] >= high)
                        .mapToDouble(edge -> x(edge, middle))
                        .toArray();
        Arrays.sort(crossings);
        double width = 0;
        for (int i = 0; i + 1 < crossings.length; i += 2) width += crossings[i + 1] - crossings[i];
        return width * (high - low);
    }

    private static double x(double[] edge, double y) {
        return edge[0] + (y - edge[1]) / (edge[3] - edge[1]) * (edge[2] - edge[0]);
    }
}
