package rasterlab.exercises.line;

import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.HashSet;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.provider.Arguments;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.engine.line.LineTopic;

/**
 * Right methods with one mistake each, and the case that is named after it: the mutants of the
 * topic, and those that only the cases of the exercise tell apart.
 */
final class LineMutants {
    private static final LineRasterizer RIGHT = new BresenhamLine();

    private LineMutants() {}

    /** The topic's mutant of that name. */
    static LineRasterizer known(String name) {
        return new LineTopic()
                .mutants().stream()
                        .filter(one -> one.name().equals(name))
                        .findFirst()
                        .orElseThrow(() -> new AssertionError("no mutant " + name))
                        .implementation();
    }

    static Stream<Arguments> all() {
        return Stream.of(
                mutant("last-pixel-is-dropped", known("last-pixel-left-out")),
                mutant("first-pixel-is-dropped", known("first-pixel-left-out")),
                mutant("line-is-shifted", LineMutants::shifted),
                mutant(
                        "axes-are-swapped",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(x0, y0, x1, y1, (x, y) -> out.plot(y, x))),
                mutant("gentle-line-leaves-gaps", LineMutants::oncePerRow),
                mutant("far-line-drifts", LineMutants::floatSum),
                mutant(
                        "slope-one-loses-a-corner",
                        withoutLastPixel((dx, dy) -> dx != 0 && Math.abs(dx) == Math.abs(dy))),
                mutant(
                        "leftward-draws-nothing",
                        (x0, y0, x1, y1, out) -> {
                            if (x0 <= x1) RIGHT.draw(x0, y0, x1, y1, out);
                        }),
                mutant(
                        "horizontal-leftward-stops",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(x0, y0, y0 == y1 && x1 < x0 ? x0 : x1, y1, out)),
                mutant("upward-goes-down", known("never-upwards")),
                mutant("backwards-other-pixels", roundedDown((dx, dy) -> dx < 0)),
                mutant("elsewhere-other-pixels", LineMutants::roundedToZero),
                mutant("octants-differ", roundedDown((dx, dy) -> Math.abs(dy) > Math.abs(dx))),
                mutant("single-point-is-skipped", known("single-point-skipped")),
                mutant(
                        "vertical-divides-by-zero",
                        (x0, y0, x1, y1, out) -> {
                            if (x0 == x1 && y0 != y1) throw new ArithmeticException("/ by zero");
                            RIGHT.draw(x0, y0, x1, y1, out);
                        }),
                mutant(
                        "pixels-come-backwards",
                        (x0, y0, x1, y1, out) -> RIGHT.draw(x1, y1, x0, y0, out)),
                mutant("steep-line-leaves-gaps", known("one-pixel-a-column")),
                mutant("steep-leftward-mixes-axes", LineMutants::axesMixed),
                mutant("negative-coordinates-round-to-zero", LineMutants::roundedToZero),
                mutant("swapped-ends-differ-on-ties", known("ties-to-the-larger")),
                mutant("steep-swapped-ends-differ-on-ties", known("ties-to-the-larger")),
                mutant("beyond-2-30-overflows", LineMutants::intDifferences),
                mutant("last-column-never-ends", LineMutants::columnCounter),
                mutant("long-line-drifts", LineMutants::floatSum));
    }

    private static Arguments mutant(String name, LineRasterizer method) {
        return argumentSet(name, name, method);
    }

    /** Whether a segment of that width and height is meant. */
    private interface Slope {
        boolean is(int dx, int dy);
    }

    private static LineRasterizer withoutLastPixel(Slope slope) {
        return (x0, y0, x1, y1, out) ->
                RIGHT.draw(
                        x0,
                        y0,
                        x1,
                        y1,
                        (x, y) -> {
                            if (x != x1 || y != y1 || !slope.is(x1 - x0, y1 - y0)) out.plot(x, y);
                        });
    }

    /** Where the slope is such, each pixel is the one at or above the line, or left of it. */
    private static LineRasterizer roundedDown(Slope slope) {
        return (x0, y0, x1, y1, out) -> {
            long dx = (long) x1 - x0;
            long dy = (long) y1 - y0;
            long n = Math.max(Math.abs(dx), Math.abs(dy));
            if (n == 0 || !slope.is(x1 - x0, y1 - y0)) RIGHT.draw(x0, y0, x1, y1, out);
            else
                for (long k = 0; k <= n; k++)
                    out.plot(
                            (int) (x0 + Math.floorDiv(k * dx, n)),
                            (int) (y0 + Math.floorDiv(k * dy, n)));
        };
    }

    static void shifted(int x0, int y0, int x1, int y1, Pixels out) {
        RIGHT.draw(x0, y0, x1, y1, (x, y) -> out.plot(x, y + 1));
    }

    private static void oncePerRow(int x0, int y0, int x1, int y1, Pixels out) {
        boolean gentle = Math.abs((long) y1 - y0) < Math.abs((long) x1 - x0);
        Set<Integer> seen = new HashSet<>();
        RIGHT.draw(
                x0,
                y0,
                x1,
                y1,
                (x, y) -> {
                    if (!gentle || seen.add(y)) out.plot(x, y);
                });
    }

    /** A steep line to the left gets its width for its height, and goes down for up. */
    private static void axesMixed(int x0, int y0, int x1, int y1, Pixels out) {
        boolean steep = Math.abs((long) y1 - y0) > Math.abs((long) x1 - x0);
        if (steep && x1 < x0) {
            int across = Math.abs(y1 - y0);
            int along = y1 < y0 ? x0 - x1 : x1 - x0;
            RIGHT.draw(x0, y0, x0 - across, y0 + along, out);
        } else RIGHT.draw(x0, y0, x1, y1, out);
    }

    private static void roundedToZero(int x0, int y0, int x1, int y1, Pixels out) {
        RIGHT.draw(
                2 * x0,
                2 * y0,
                2 * x1,
                2 * y1,
                (x, y) -> {
                    if (x % 2 == 0) out.plot(x / 2, (int) (y / 2.0 + 0.5));
                });
    }

    /** Draws right, but for the two differences, which are ints. */
    private static void intDifferences(int x0, int y0, int x1, int y1, Pixels out) {
        int dx = x1 - x0;
        int dy = y1 - y0;
        long n = Math.max(Math.abs(dx), Math.abs(dy));
        for (long k = 0; k <= n; k++)
            out.plot((int) (x0 + nearest(k * dx, n)), (int) (y0 + nearest(k * dy, n)));
    }

    /** Flat lines to the right by a loop that cannot get beyond the last column there is. */
    private static void columnCounter(int x0, int y0, int x1, int y1, Pixels out) {
        long dx = (long) x1 - x0;
        long dy = (long) y1 - y0;
        if (dx < Math.abs(dy)) RIGHT.draw(x0, y0, x1, y1, out);
        else
            for (int x = x0; x <= x1; x++)
                out.plot(x, (int) (y0 + nearest(((long) x - x0) * dy, dx)));
    }

    /** Flat lines to the right by adding the slope up in a float. */
    private static void floatSum(int x0, int y0, int x1, int y1, Pixels out) {
        long dx = (long) x1 - x0;
        if (dx < Math.abs((long) y1 - y0) || dx > 1 << 20) {
            RIGHT.draw(x0, y0, x1, y1, out);
            return;
        }
        float y = y0;
        for (long x = x0; x <= x1; x++) {
            out.plot((int) x, Math.round(y));
            y += (float) (y1 - y0) / dx;
        }
    }

    /** a / n to the nearest whole number, a half to the smaller one; 0 where n is 0. */
    private static long nearest(long a, long n) {
        return n == 0 ? 0 : -Math.floorDiv(n - 2 * a, 2 * n);
    }
}
