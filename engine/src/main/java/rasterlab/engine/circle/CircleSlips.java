package rasterlab.engine.circle;

import java.util.List;
import java.util.stream.IntStream;
import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.study.Slip;

/** Circles of another radius, at another place, or with a part too much or too little. */
final class CircleSlips {
    private CircleSlips() {}

    static List<Slip<CircleRasterizer>> of(CircleRasterizer right) {
        return List.of(
                Slip.of(
                        "radius-too-small",
                        (x, y, r, out) -> right.draw(x, y, Math.max(0, r - 1), out)),
                Slip.of("radius-too-large", (x, y, r, out) -> right.draw(x, y, r + 1, out)),
                Slip.of("radius-as-diameter", (x, y, r, out) -> right.draw(x, y, r / 2, out)),
                Slip.of("diameter-as-radius", (x, y, r, out) -> right.draw(x, y, 2 * r, out)),
                Slip.of("center-subtracted", (x, y, r, out) -> right.draw(-x, -y, r, out)),
                Slip.of(
                        "one-coordinate-for-both",
                        (x, y, r, out) -> right.draw(x, x, r, out),
                        (x, y, r, out) -> right.draw(y, y, r, out)),
                Slip.of(
                        "root-rounded-up",
                        CircleMutants.byRoots(
                                (r, u) ->
                                        (int)
                                                Math.ceil(
                                                        Math.sqrt(
                                                                (double) r * r - (double) u * u)))),
                Slip.of("disc-filled", (x, y, r, out) -> disc(right, x, y, r, out)),
                new Slip<>(
                        "octant-left-out",
                        IntStream.range(0, 8).mapToObj(i -> without(right, i)).toList()),
                new Slip<>(
                        "quarter-left-out",
                        IntStream.range(0, 4).mapToObj(i -> withoutQuarter(right, i)).toList()));
    }

    private static void disc(CircleRasterizer right, int x, int y, int r, Pixels out) {
        int[] wide = new int[2 * r + 1];
        right.draw(x, y, r, (px, py) -> wide[py - y + r] = Math.max(wide[py - y + r], px - x));
        for (int v = -r; v <= r; v++)
            for (int u = -wide[v + r]; u <= wide[v + r]; u++) out.plot(x + u, y + v);
    }

    /** The pixels on axes and diagonals stay, as images of their neighbours across them do. */
    private static CircleRasterizer without(CircleRasterizer right, int octant) {
        return (x, y, r, out) ->
                right.draw(
                        x,
                        y,
                        r,
                        (px, py) -> {
                            int u = Math.abs(px - x);
                            int v = Math.abs(py - y);
                            boolean inside = u != 0 && v != 0 && u != v;
                            int at = (px > x ? 1 : 0) + (py > y ? 2 : 0) + (u > v ? 4 : 0);
                            if (!inside || at != octant) out.plot(px, py);
                        });
    }

    private static CircleRasterizer withoutQuarter(CircleRasterizer right, int quarter) {
        return (x, y, r, out) ->
                right.draw(
                        x,
                        y,
                        r,
                        (px, py) -> {
                            boolean inside = px != x && py != y;
                            int at = (px > x ? 1 : 0) + (py > y ? 2 : 0);
                            if (!inside || at != quarter) out.plot(px, py);
                        });
    }
}
