package rasterlab.engine.polygon.inside;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.PointInPolygon;
import rasterlab.engine.study.Slip;

/** Points judged by a box, a line or some edges alone. */
final class PointInPolygonSlips {
    private PointInPolygonSlips() {}

    static List<Slip<PointInPolygon>> of(PointInPolygon right) {
        return List.of(
                Slip.of("box-for-polygon", PointInPolygonSlips::inBox),
                Slip.of("point-x-y-swapped", (px, py, x, y) -> right.contains(px, py, y, x)),
                Slip.of(
                        "line-for-ray",
                        (px, py, x, y) -> onEdge(px, py, x, y) || odd(px, py, x, y, Ray.LINE)),
                Slip.of(
                        "any-crossing-is-inside",
                        (px, py, x, y) ->
                                onEdge(px, py, x, y) || crossings(px, py, x, y, Ray.ALL) > 0),
                Slip.of(
                        "one-direction-of-edges",
                        (px, py, x, y) -> onEdge(px, py, x, y) || odd(px, py, x, y, Ray.UP),
                        (px, py, x, y) -> onEdge(px, py, x, y) || odd(px, py, x, y, Ray.DOWN)),
                Slip.of(
                        "ends-never-crossed",
                        (px, py, x, y) -> onEdge(px, py, x, y) || odd(px, py, x, y, Ray.OPEN)),
                Slip.of(
                        "first-edge-missing",
                        (px, py, x, y) -> {
                            int n = px.length;
                            double[] qx = Arrays.copyOfRange(px, 1, n);
                            double[] qy = Arrays.copyOfRange(py, 1, n);
                            return open(qx, qy, px[0], py[0], x, y);
                        }));
    }

    private enum Ray {
        ALL,
        LINE,
        UP,
        DOWN,
        OPEN
    }

    private static boolean inBox(double[] px, double[] py, double x, double y) {
        return Arrays.stream(px).anyMatch(one -> one <= x)
                && Arrays.stream(px).anyMatch(one -> one >= x)
                && Arrays.stream(py).anyMatch(one -> one <= y)
                && Arrays.stream(py).anyMatch(one -> one >= y);
    }

    private static boolean odd(double[] px, double[] py, double x, double y, Ray ray) {
        return crossings(px, py, x, y, ray) % 2 == 1;
    }

    private static int crossings(double[] px, double[] py, double x, double y, Ray ray) {
        int count = 0;
        for (int i = 0; i < px.length; i++) {
            int j = (i + 1) % px.length;
            if (crosses(px[i], py[i], px[j], py[j], x, y, ray)) count++;
        }
        return count;
    }

    private static boolean crosses(
            double x0, double y0, double x1, double y1, double x, double y, Ray ray) {
        boolean up = y0 <= y && y < y1;
        boolean down = y1 <= y && y < y0;
        if (ray == Ray.OPEN && (y == y0 || y == y1) || !up && !down) return false;
        if (ray == Ray.UP && !up || ray == Ray.DOWN && !down) return false;
        return ray == Ray.LINE || x0 + (y - y0) * (x1 - x0) / (y1 - y0) > x;
    }

    private static boolean onEdge(double[] px, double[] py, double x, double y) {
        for (int i = 0; i < px.length; i++) {
            int j = (i + 1) % px.length;
            if (isOn(px[i], py[i], px[j], py[j], x, y)) return true;
        }
        return false;
    }

    private static boolean isOn(double x0, double y0, double x1, double y1, double x, double y) {
        double cross = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0);
        return cross == 0
                && x >= Math.min(x0, x1)
                && x <= Math.max(x0, x1)
                && y >= Math.min(y0, y1)
                && y <= Math.max(y0, y1);
    }

    /** The outline without the edge from its first vertex to its second. */
    private static boolean open(
            double[] qx, double[] qy, double x0, double y0, double x, double y) {
        boolean inside = false;
        for (int i = 0; i < qx.length; i++) {
            boolean last = i + 1 == qx.length;
            double toX = last ? x0 : qx[i + 1];
            double toY = last ? y0 : qy[i + 1];
            if (isOn(qx[i], qy[i], toX, toY, x, y)) return true;
            inside ^= crosses(qx[i], qy[i], toX, toY, x, y, Ray.ALL);
        }
        return inside;
    }
}
