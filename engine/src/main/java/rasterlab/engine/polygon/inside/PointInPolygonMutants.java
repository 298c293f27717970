package rasterlab.engine.polygon.inside;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.PointInPolygon;
import rasterlab.engine.study.Mutant;

/** Points judged by a polygon with one mistake. */
final class PointInPolygonMutants {
    private static final PointInPolygon RIGHT = new RobustRay();

    private PointInPolygonMutants() {}

    static List<Mutant<PointInPolygon>> all() {
        return Stream.of(ofRays(), ofBorders(), ofShapes()).flatMap(List::stream).toList();
    }

    private static List<Mutant<PointInPolygon>> ofRays() {
        return List.of(
                new Mutant<>(
                        "corner-counts-twice",
                        "ray-through-a-corner",
                        byRay((low, high, y) -> low != high && low <= y && y <= high)),
                new Mutant<>(
                        "level-edge-crossed",
                        "ray-along-an-edge",
                        byRay((low, high, y) -> low <= y && y < high || low == y && high == y)),
                new Mutant<>(
                        "last-edge-missing",
                        "last-edge",
                        (px, py, x, y) ->
                                odd(px, py, px.length - 1, x, y, (l, h, at) -> l <= at && at < h)));
    }

    /** Mistakes about the boundary, on which rays say this or that. */
    private static List<Mutant<PointInPolygon>> ofBorders() {
        Crosses lowerEnds = (low, high, y) -> low <= y && y < high;
        Crosses upperEnds = (low, high, y) -> low < y && y <= high;
        return List.of(
                new Mutant<>("boundary-by-ray", "on-the-boundary", byRay(lowerEnds)),
                new Mutant<>("boundary-by-ray-above", "on-the-boundary", byRay(upperEnds)),
                new Mutant<>(
                        "boundary-by-ray-to-the-left",
                        "on-the-boundary",
                        (px, py, x, y) -> byRay(lowerEnds).contains(negative(px), py, -x, y)),
                new Mutant<>(
                        "boundary-outside",
                        "on-the-boundary",
                        onEdges(
                                (x0, y0, x1, y1, x, y) -> within(x0, x1, x) && within(y0, y1, y),
                                false)),
                new Mutant<>(
                        "vertex-by-ray",
                        "on-the-boundary",
                        onEdges(
                                (x0, y0, x1, y1, x, y) ->
                                        within(x0, x1, x)
                                                && within(y0, y1, y)
                                                && !(x == x0 && y == y0)
                                                && !(x == x1 && y == y1),
                                true)),
                new Mutant<>(
                        "beyond-the-ends",
                        "in-line-with-edges",
                        onEdges(
                                (x0, y0, x1, y1, x, y) ->
                                        (x0 != x1 || y0 != y1) || x == x0 && y == y0,
                                true)),
                new Mutant<>(
                        "ends-by-x-alone",
                        "in-line-with-edges",
                        onEdges((x0, y0, x1, y1, x, y) -> within(x0, x1, x), true)));
    }

    private static List<Mutant<PointInPolygon>> ofShapes() {
        return List.of(
                new Mutant<>("non-zero-rule", "covered-twice", PointInPolygonMutants::nonZero),
                new Mutant<>(
                        "flat-is-whole-box",
                        "no-area",
                        (px, py, x, y) ->
                                area(px, py) == 0
                                        ? within(px, x) && within(py, y)
                                        : RIGHT.contains(px, py, x, y)),
                new Mutant<>(
                        "edge-is-whole-line",
                        "ray-along-an-edge",
                        (px, py, x, y) -> onLine(px, py, x, y) || RIGHT.contains(px, py, x, y)),
                new Mutant<>(
                        "taken-for-convex",
                        "no-corner-at-the-ray",
                        PointInPolygonMutants::asIfConvex));
    }

    private interface Crosses {
        boolean ray(double low, double high, double y);
    }

    private static PointInPolygon byRay(Crosses crosses) {
        return (px, py, x, y) -> odd(px, py, px.length, x, y, crosses);
    }

    private interface Meets {
        boolean edge(double x0, double y0, double x1, double y1, double x, double y);
    }

    /**
     * Says the same of all points in line with an edge that meet it; of others a ray decides.
     *
     * @param inside what is said of them
     */
    private static PointInPolygon onEdges(Meets meets, boolean inside) {
        PointInPolygon others = byRay((low, high, y) -> low <= y && y < high);
        return (px, py, x, y) -> {
            for (int i = 0; i < px.length; i++) {
                int j = (i + 1) % px.length;
                double cross = (px[j] - px[i]) * (y - py[i]) - (py[j] - py[i]) * (x - px[i]);
                if (cross == 0 && meets.edge(px[i], py[i], px[j], py[j], x, y)) return inside;
            }
            return others.contains(px, py, x, y);
        };
    }

    private static boolean within(double one, double other, double x) {
        return Math.min(one, other) <= x && x <= Math.max(one, other);
    }

    private static double[] negative(double[] all) {
        return Arrays.stream(all).map(each -> -each).toArray();
    }

    private static boolean odd(
            double[] px, double[] py, int edges, double x, double y, Crosses crosses) {
        boolean inside = false;
        for (int i = 0; i < edges; i++) {
            int j = (i + 1) % px.length;
            if (!crosses.ray(Math.min(py[i], py[j]), Math.max(py[i], py[j]), y)) continue;
            double at =
                    py[i] == py[j]
                            ? Math.max(px[i], px[j])
                            : px[i] + (y - py[i]) / (py[j] - py[i]) * (px[j] - px[i]);
            if (at > x) inside = !inside;
        }
        return inside;
    }

    private static boolean nonZero(double[] px, double[] py, double x, double y) {
        int winding = 0;
        for (int i = 0; i < px.length; i++) {
            int j = (i + 1) % px.length;
            if (py[i] <= y == py[j] <= y) continue;
            double at = px[i] + (y - py[i]) / (py[j] - py[i]) * (px[j] - px[i]);
            if (at > x) winding += py[i] <= y ? 1 : -1;
        }
        return winding != 0;
    }

    private static double area(double[] px, double[] py) {
        double twice = 0;
        for (int i = 0; i < px.length; i++) {
            int j = (i + 1) % px.length;
            twice += px[i] * py[j] - px[j] * py[i];
        }
        return twice;
    }

    private static boolean within(double[] corners, double coordinate) {
        return coordinate >= Arrays.stream(corners).min().orElseThrow()
                && coordinate <= Arrays.stream(corners).max().orElseThrow();
    }

    private static boolean onLine(double[] px, double[] py, double x, double y) {
        for (int i = 0; i < px.length; i++) {
            int j = (i + 1) % px.length;
            if (side(px, py, i, j, x, y) == 0) return true;
        }
        return false;
    }

    private static double side(double[] px, double[] py, int i, int j, double x, double y) {
        return (px[j] - px[i]) * (y - py[i]) - (py[j] - py[i]) * (x - px[i]);
    }

    private static boolean asIfConvex(double[] px, double[] py, double x, double y) {
        boolean left = false;
        boolean right = false;
        for (int i = 0; i < px.length; i++) {
            double side = side(px, py, i, (i + 1) % px.length, x, y);
            left |= side > 0;
            right |= side < 0;
        }
        return !(left && right);
    }
}
