package rasterlab.exercises.line;

import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.line.BresenhamLine;

/**
 * A right method with one mistake, or with two at once, and what grading should make of it.
 *
 * @param message cause and place in the report
 * @param points out of 100, if it is as quick as the reference
 */
record OneMistake(String name, int points, String message, LineRasterizer method) {
    private static final LineRasterizer RIGHT = new BresenhamLine();
    private static final LineRasterizer WITHOUT_FIRST = LineMutants.known("first-pixel-left-out");

    static final List<OneMistake> ALL =
            List.of(
                    by("last missing", 92, "the last pixel is missing", (k, n) -> k < n ? 1 : 0),
                    by("first missing", 93, "the first pixel is missing", (k, n) -> k > 0 ? 1 : 0),
                    by(
                            "both ends missing",
                            87,
                            "Two mistakes explain all that is wrong –"
                                    + " the first pixel is missing, and the last pixel is missing",
                            (k, n) -> k > 0 && k < n ? 1 : 0),
                    by(
                            "one beyond the last end",
                            94,
                            "it goes one pixel beyond the last end",
                            (k, n) -> k >= 0 ? 1 : 0,
                            1),
                    by(
                            "one before the first end",
                            95,
                            "it goes one pixel beyond the first end",
                            (k, n) -> 1,
                            0),
                    by("each twice", 95, "each pixel is drawn twice", (k, n) -> 2),
                    by("last twice", 95, "the last pixel is drawn twice", (k, n) -> k == n ? 2 : 1),
                    by(
                            "first twice",
                            95,
                            "the first pixel is drawn twice",
                            (k, n) -> k == 0 ? 2 : 1),
                    by(
                            "begins and ends late",
                            90,
                            "shifted by one pixel along itself: it begins after the first end",
                            (k, n) -> k > 0 ? 1 : 0,
                            1),
                    of(
                            "backwards",
                            95,
                            "the pixels come in reverse order, from the last end to the first. This shows on every line",
                            (x0, y0, x1, y1, out) -> RIGHT.draw(x1, y1, x0, y0, out)),
                    of(
                            "backwards to the left",
                            95,
                            "from the last end to the first. This shows only on lines to the left",
                            LineMutants.known("always-from-the-left")),
                    moved(
                            "all shifted by one",
                            90,
                            "the line is shifted by +1 in x and 0 in y",
                            (x, y, out) -> out.plot(x + 1, y)),
                    moved(
                            "all mirrored",
                            88,
                            "the line is mirrored: left and right are exchanged",
                            (x, y, out) -> out.plot(-x, y)),
                    moved(
                            "axes swapped",
                            88,
                            "x and y are exchanged",
                            (x, y, out) -> out.plot(y, x)),
                    of(
                            "no sign in y",
                            89,
                            "it goes the wrong way in y: up and down are exchanged. This shows only on lines upwards",
                            (x0, y0, x1, y1, out) ->
                                    RIGHT.draw(
                                            x0,
                                            y0,
                                            x1,
                                            y1,
                                            (x, y) -> out.plot(x, y0 + Math.abs(y - y0)))),
                    of(
                            "no sign in x",
                            89,
                            "it goes the wrong way in x: left and right are exchanged. This shows only on lines to the left",
                            (x0, y0, x1, y1, out) ->
                                    RIGHT.draw(
                                            x0,
                                            y0,
                                            x1,
                                            y1,
                                            (x, y) -> out.plot(x0 + Math.abs(x - x0), y))),
                    of(
                            "ties to the larger",
                            91,
                            "ties go to the larger coordinate",
                            LineMutants.known("ties-to-the-larger")),
                    of(
                            "first missing to the left",
                            95,
                            "the first pixel is missing. This shows only on lines to the left",
                            (x0, y0, x1, y1, out) -> {
                                if (x1 < x0) WITHOUT_FIRST.draw(x0, y0, x1, y1, out);
                                else RIGHT.draw(x0, y0, x1, y1, out);
                            }),
                    of(
                            "a gap in one octant",
                            88,
                            "",
                            (x0, y0, x1, y1, out) -> {
                                boolean there =
                                        x1 < x0 && y1 < y0 && y0 - (long) y1 > x0 - (long) x1;
                                if (there) gapAfterTheFirst(x0, y0, x1, y1, out);
                                else RIGHT.draw(x0, y0, x1, y1, out);
                            }));

    /** How often pixel k of 0 … n is drawn. */
    private interface Times {
        int of(long k, long n);
    }

    private interface Move {
        void plot(int x, int y, Pixels out);
    }

    private static OneMistake of(String name, int points, String said, LineRasterizer method) {
        return new OneMistake(name, points, said, method);
    }

    private static OneMistake moved(String name, int points, String said, Move move) {
        return of(
                name,
                points,
                said + ". This shows on every line",
                (x0, y0, x1, y1, out) ->
                        RIGHT.draw(x0, y0, x1, y1, (x, y) -> move.plot(x, y, out)));
    }

    /** A mistake without pixels beyond the ends. */
    private static OneMistake by(String name, int points, String said, Times times) {
        return of(name, points, said + ". This shows on every line", walk(0, 0, times));
    }

    /** A mistake with pixel −1 where {@code times} has it, and those up to n + {@code beyond}. */
    private static OneMistake by(String name, int points, String said, Times times, int beyond) {
        return of(name, points, said, walk(-1, beyond, times));
    }

    private static LineRasterizer walk(int from, int beyond, Times times) {
        return (x0, y0, x1, y1, out) -> {
            long dx = (long) x1 - x0;
            long dy = (long) y1 - y0;
            long n = Math.max(Math.abs(dx), Math.abs(dy));
            for (long k = from; k <= n + beyond; k++)
                for (int left = times.of(k, n); left > 0; left--)
                    out.plot(
                            (int) (x0 + (n == 0 ? k : nearest(k * dx, n))),
                            (int) (y0 + (n == 0 ? 0 : nearest(k * dy, n))));
        };
    }

    /** a / n to the nearest whole number, a half to the smaller one. */
    private static long nearest(long a, long n) {
        return -Math.floorDiv(n - 2 * a, 2 * n);
    }

    private static void gapAfterTheFirst(int x0, int y0, int x1, int y1, Pixels out) {
        int[] drawn = {0};
        RIGHT.draw(
                x0,
                y0,
                x1,
                y1,
                (x, y) -> {
                    if (drawn[0]++ != 1) out.plot(x, y);
                });
    }

    @Override
    public String toString() {
        return name;
    }
}
