package rasterlab.engine.polygon.inside;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.PointInPolygon;
import rasterlab.engine.study.Mutant;

/** Points judged by a polygon with one mistake. */
final class PointInPolygonMutants {
    private static final PointInPolygon RIGHT = new RobustRay();

    private PointInPolygonMutants() {}

    static List<Mutant<PointInPolygon>> all() {
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
                        "boundary-by-ray",
                        "on-the-boundary",
                        byRay((low, high, y) -> low <= y && y < high)),
                new Mutant<>(
                        "last-edge-missing",
                        "last-edge",
                        (px, py, x, y) ->
                                odd(px, py, px.length - 1, x, y, (l, h, at) -> l <= at && at < h)),
                new Mutant<>("non-zero-rule", "covered-twice", PointInPolygonMutants::nonZero),
                new Mutant<>(
                        "flat-is-whole-box",
                        "no-area",
                        (px, py, x, y) ->
                                area(px, py) == 0
                                        ? within(px, x) && within(py, y)
                                        : RIGHT.contains(px, py, x, y)));
    }

    private interface Crosses {
        boolean ray(double low, double high, double y);
    }

    private static PointInPolygon byRay(Crosses crosses) {
        return (px, py, x, y) -> odd(px, py, px.length, x, y, crosses);
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
}
