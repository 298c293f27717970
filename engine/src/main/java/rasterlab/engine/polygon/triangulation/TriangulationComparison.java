package rasterlab.engine.polygon.triangulation;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.study.Deviation;

/**
 * Whether triangles cover a polygon once and nothing else, proved instead of compared: a polygon
 * has many triangulations.
 *
 * <p>It is so exactly when every triangle goes counter-clockwise and the sides add up to the
 * polygon's edges: each side that is no edge is gone along both ways equally often, each edge once
 * more in the polygon's direction. Then every point is covered as often as the edges wind round it.
 *
 * <p>The error is the difference between the triangles' areas, each taken as positive, and the
 * polygon's, in percent of that; where they add up and still do not fit, {@value #LEAST_PERCENT}.
 */
final class TriangulationComparison {
    private static final double LEAST_PERCENT = 1e-6;

    private final ExactTriangulation polygon;
    private final int corners;
    private final Triangles actual;

    private TriangulationComparison(Points corners, Triangles actual) {
        polygon = new ExactTriangulation(corners);
        this.corners = corners.size();
        this.actual = actual;
    }

    static Deviation compare(Points corners, Triangles exact, Triangles actual) {
        int of = exact.size();
        if (of == 0 && actual.size() == 0) return Deviation.NONE;
        var comparison = new TriangulationComparison(corners, actual);
        String first = comparison.firstFault(of);
        if (first.isEmpty()) return new Deviation(0, 0, 0, of, "");
        return new Deviation(
                comparison.percent(of),
                Math.max(0, of - actual.size()),
                Math.max(0, actual.size() - of),
                of,
                first);
    }

    private String firstFault(int of) {
        if (of == 0) return "there are triangles where the polygon has no inside";
        for (int t = 0; t < actual.size(); t++) {
            String fault = faultOf(t);
            if (!fault.isEmpty()) return actual.name(t) + " " + fault;
        }
        return sides().entrySet().stream()
                .filter(side -> side.getValue() != 0)
                .findFirst()
                .map(side -> "side " + side.getKey() + " is gone along once too " + excess(side))
                .orElse("");
    }

    private static String excess(Map.Entry<List<Integer>, Integer> side) {
        return side.getValue() > 0 ? "often" : "seldom";
    }

    private String faultOf(int triangle) {
        for (int k = 0; k < 3; k++) {
            int corner = actual.corner(triangle, k);
            if (corner < 0 || corner >= corners) return "has no such corner as " + corner;
        }
        int turn = doubledArea(triangle).signum();
        return turn > 0 ? "" : turn == 0 ? "has no area" : "goes clockwise";
    }

    private BigDecimal doubledArea(int t) {
        return polygon.doubledArea(actual.corner(t, 0), actual.corner(t, 1), actual.corner(t, 2));
    }

    /** Times each side is gone along from its smaller to its larger corner, less the polygon's. */
    private TreeMap<List<Integer>, Integer> sides() {
        var sides =
                new TreeMap<List<Integer>, Integer>(
                        Comparator.<List<Integer>>comparingInt(side -> side.get(0))
                                .thenComparingInt(side -> side.get(1)));
        for (int t = 0; t < actual.size(); t++)
            for (int k = 0; k < 3; k++)
                add(sides, actual.corner(t, k), actual.corner(t, (k + 1) % 3), 1);
        List<Integer> ring = polygon.ring();
        for (int k = 0; k < ring.size(); k++)
            add(sides, ring.get(k), ring.get((k + 1) % ring.size()), -1);
        return sides;
    }

    private void add(TreeMap<List<Integer>, Integer> sides, int from, int to, int times) {
        int i = polygon.standIn(from);
        int j = polygon.standIn(to);
        if (i < j) sides.merge(List.of(i, j), times, Integer::sum);
        else sides.merge(List.of(j, i), -times, Integer::sum);
    }

    private double percent(int of) {
        if (of == 0) return 100;
        BigDecimal area = BigDecimal.ZERO;
        for (int t = 0; t < actual.size(); t++)
            if (!faultOf(t).startsWith("has no such")) area = area.add(doubledArea(t).abs());
        BigDecimal right = polygon.doubledArea();
        if (right.signum() == 0) return 100;
        double share =
                area.subtract(right).abs().divide(right, MathContext.DECIMAL64).doubleValue();
        return Math.max(LEAST_PERCENT, 100 * share);
    }
}
