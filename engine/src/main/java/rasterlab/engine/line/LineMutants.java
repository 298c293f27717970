package rasterlab.engine.line;

import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.study.Mutant;

/** Segments drawn with one mistake. */
final class LineMutants {
    private static final LineRasterizer RIGHT = new BresenhamLine();

    private LineMutants() {}

    static List<Mutant<LineRasterizer>> all() {
        return List.of(
                new Mutant<>("last-pixel-left-out", "both-ends", LineMutants::withoutLast),
                new Mutant<>("first-pixel-left-out", "both-ends", LineMutants::withoutFirst),
                new Mutant<>("ties-to-the-larger", "ties", LineMutants::tiesDown),
                new Mutant<>(
                        "always-from-the-left",
                        "leftward",
                        (x0, y0, x1, y1, out) -> {
                            if (x0 <= x1) RIGHT.draw(x0, y0, x1, y1, out);
                            else RIGHT.draw(x1, y1, x0, y0, out);
                        }),
                new Mutant<>("one-pixel-a-column", "steep", LineMutants::byColumns),
                new Mutant<>(
                        "never-upwards",
                        "upward",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(x0, y0, x1, y0 + Math.abs(y1 - y0), out)),
                new Mutant<>(
                        "single-point-skipped",
                        "single-point",
                        (x0, y0, x1, y1, out) -> {
                            if (x0 != x1 || y0 != y1) RIGHT.draw(x0, y0, x1, y1, out);
                        }),
                new Mutant<>("products-in-int", "products-beyond-int", LineMutants::productsInInt),
                new Mutant<>("steps-in-float", "beyond-2-24", LineMutants::countedByFloat),
                new Mutant<>(
                        "coordinates-in-float",
                        "far-away",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(
                                        (int) (float) x0,
                                        (int) (float) y0,
                                        (int) (float) x1,
                                        (int) (float) y1,
                                        out)),
                new Mutant<>(
                        "slope-in-whole-numbers",
                        "first-octant",
                        stepped((start, difference, k, n) -> start + k * (difference / n))),
                new Mutant<>(
                        "quotient-truncated",
                        "first-octant",
                        stepped((start, difference, k, n) -> start + k * difference / n)),
                new Mutant<>(
                        "coordinate-truncated",
                        "first-octant",
                        stepped(
                                (start, difference, k, n) ->
                                        (long) (start + k * ((double) difference / n)))));
    }

    /** A coordinate of pixel k of 0 … n. */
    private interface Coordinate {
        long at(long start, long difference, long k, long n);
    }

    /**
     * Draws right along the longer axis, whatever is lost of a fraction, as long as nothing
     * overflows.
     */
    private static LineRasterizer stepped(Coordinate coordinate) {
        return (x0, y0, x1, y1, out) -> {
            long dx = (long) x1 - x0;
            long dy = (long) y1 - y0;
            long n = Math.max(1, Math.max(Math.abs(dx), Math.abs(dy)));
            long last = dx == 0 && dy == 0 ? 0 : n;
            for (long k = 0; k <= last; k++)
                out.plot((int) coordinate.at(x0, dx, k, n), (int) coordinate.at(y0, dy, k, n));
        };
    }

    private static void withoutLast(int x0, int y0, int x1, int y1, Pixels out) {
        RIGHT.draw(
                x0,
                y0,
                x1,
                y1,
                (x, y) -> {
                    if (x != x1 || y != y1) out.plot(x, y);
                });
    }

    private static void withoutFirst(int x0, int y0, int x1, int y1, Pixels out) {
        RIGHT.draw(
                x0,
                y0,
                x1,
                y1,
                (x, y) -> {
                    if (x != x0 || y != y0) out.plot(x, y);
                });
    }

    /** Draws right for 0 ≤ y1 − y0 ≤ x1 − x0 as long as no product overflows. */
    private static void productsInInt(int x0, int y0, int x1, int y1, Pixels out) {
        int n = x1 - x0;
        int b = y1 - y0;
        if (b < 0 || b > n) RIGHT.draw(x0, y0, x1, y1, out);
        else
            for (int i = 0; i <= n; i++) {
                int along = i * b;
                out.plot(x0 + i, y0 + (n == 0 ? 0 : (int) -Math.floorDiv(n - 2L * along, 2L * n)));
            }
    }

    /**
     * Counts in floats: beyond 2²⁴ a float plus 1 is itself, so the pixel is drawn again and again.
     */
    private static void countedByFloat(int x0, int y0, int x1, int y1, Pixels out) {
        var count = new float[1];
        var last = new int[2];
        RIGHT.draw(
                x0,
                y0,
                x1,
                y1,
                (x, y) -> {
                    boolean moves = count[0] + 1 > count[0];
                    if (moves) last[0] = x;
                    if (moves) last[1] = y;
                    out.plot(last[0], last[1]);
                    count[0]++;
                });
    }

    /** The mirror image of a line's mirror image, whose ties go the other way. */
    private static void tiesDown(int x0, int y0, int x1, int y1, Pixels out) {
        RIGHT.draw(-x0, -y0, -x1, -y1, (x, y) -> out.plot(-x, -y));
    }

    /** Draws only the nearest pixel of each column above 45°; of an upright segment the first. */
    private static void byColumns(int x0, int y0, int x1, int y1, Pixels out) {
        long wide = Math.abs((long) x1 - x0);
        long high = (long) y1 - y0;
        if (wide >= Math.abs(high)) RIGHT.draw(x0, y0, x1, y1, out);
        else if (wide == 0) out.plot(x0, y0);
        else
            for (long i = 0; i <= wide; i++) {
                long up = Math.floorDiv(wide - 2 * i * high, 2 * wide);
                out.plot((int) (x0 + (x0 < x1 ? i : -i)), (int) (y0 - up));
            }
    }
}
