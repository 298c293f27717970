package rasterlab.engine.circle;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.study.Slip;

/** Ellipses with other half-axes, at another place, or with a part too much or too little. */
final class EllipseSlips {
    private EllipseSlips() {}

    static List<Slip<EllipseRasterizer>> of(EllipseRasterizer right) {
        return List.of(
                Slip.of(
                        "circle-drawn",
                        (x, y, a, b, out) -> right.draw(x, y, a, a, out),
                        (x, y, a, b, out) -> right.draw(x, y, b, b, out)),
                Slip.of(
                        "half-axes-as-axes",
                        (x, y, a, b, out) -> right.draw(x, y, a / 2, b / 2, out)),
                Slip.of(
                        "axes-as-half-axes",
                        (x, y, a, b, out) -> right.draw(x, y, 2 * a, 2 * b, out)),
                Slip.of(
                        "half-axis-too-small",
                        (x, y, a, b, out) -> right.draw(x, y, less(a), less(b), out)),
                Slip.of("center-x-y-swapped", (x, y, a, b, out) -> right.draw(y, x, a, b, out)),
                Slip.of("root-rounded-up", rounded(Math::ceil)),
                Slip.of("rows-only", (x, y, a, b, out) -> rows(x, y, a, b, out)),
                Slip.of("ellipse-filled", (x, y, a, b, out) -> filled(right, x, y, a, b, out)),
                new Slip<>(
                        "quarter-left-out",
                        IntStream.range(0, 4).mapToObj(i -> without(right, i)).toList()));
    }

    private static int less(int half) {
        return Math.max(0, half - 1);
    }

    private static EllipseRasterizer rounded(DoubleUnaryOperator rounding) {
        return (x, y, a, b, out) ->
                EllipseMutants.byBoth(x, y, a, b, rounding, (u, v) -> true, (u, v) -> true, out);
    }

    /** Draws in each row the pixels that are nearest to the curve, and no others. */
    private static void rows(int x, int y, int a, int b, Pixels out) {
        for (int v = 0; v <= b; v++) {
            double share = b == 0 ? 0 : (double) v / b;
            int u = (int) Math.rint(a * Math.sqrt((1 - share) * (1 + share)));
            for (int py : v == 0 ? new int[] {y} : new int[] {y - v, y + v}) {
                out.plot(x - u, py);
                if (u > 0) out.plot(x + u, py);
            }
        }
    }

    private static void filled(EllipseRasterizer right, int x, int y, int a, int b, Pixels out) {
        int[] wide = new int[2 * b + 1];
        right.draw(x, y, a, b, (px, py) -> wide[py - y + b] = Math.max(wide[py - y + b], px - x));
        for (int v = -b; v <= b; v++)
            for (int u = -wide[v + b]; u <= wide[v + b]; u++) out.plot(x + u, y + v);
    }

    private static EllipseRasterizer without(EllipseRasterizer right, int quarter) {
        return (x, y, a, b, out) ->
                right.draw(
                        x,
                        y,
                        a,
                        b,
                        (px, py) -> {
                            boolean inside = px != x && py != y;
                            int at = (px > x ? 1 : 0) + (py > y ? 2 : 0);
                            if (!inside || at != quarter) out.plot(px, py);
                        });
    }
}
