package rasterlab.engine.circle;

import java.util.HashSet;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.study.Mutant;

/** Ellipses drawn with one mistake. */
final class EllipseMutants {
    private static final EllipseRasterizer RIGHT = new MidpointEllipse();

    private EllipseMutants() {}

    static List<Mutant<EllipseRasterizer>> all() {
        return List.of(
                new Mutant<>(
                        "half-axes-swapped",
                        "very-flat",
                        (x, y, a, b, out) -> RIGHT.draw(x, y, b, a, out)),
                new Mutant<>(
                        "middle-row-left-out",
                        "very-flat",
                        (x, y, a, b, out) -> keep(x, y, a, b, (u, v) -> v > 0 || b == 0, out)),
                new Mutant<>(
                        "middle-column-left-out",
                        "very-tall",
                        (x, y, a, b, out) -> keep(x, y, a, b, (u, v) -> u > 0 || a == 0, out)),
                new Mutant<>("columns-only", "corner", EllipseMutants::columnsOnly),
                new Mutant<>(
                        "point-skipped",
                        "point",
                        (x, y, a, b, out) -> {
                            if (a > 0 || b > 0) RIGHT.draw(x, y, a, b, out);
                        }),
                new Mutant<>(
                        "products-in-int",
                        "products-beyond-int",
                        (x, y, a, b, out) -> {
                            if ((long) a * a * b == (int) ((long) a * a * b))
                                RIGHT.draw(x, y, a, b, out);
                        }),
                new Mutant<>(
                        "upright-line-skipped",
                        "upright-line",
                        (x, y, a, b, out) -> {
                            if (a > 0 || b == 0) RIGHT.draw(x, y, a, b, out);
                        }),
                new Mutant<>(
                        "center-ignored",
                        "flat-line",
                        (x, y, a, b, out) -> RIGHT.draw(0, 0, a, b, out)),
                new Mutant<>(
                        "quarter-only",
                        "corner",
                        (x, y, a, b, out) ->
                                RIGHT.draw(
                                        x,
                                        y,
                                        a,
                                        b,
                                        (px, py) -> {
                                            if (px >= x && py >= y) out.plot(px, py);
                                        })),
                new Mutant<>("axes-twice", "very-flat", EllipseMutants::axesTwice),
                new Mutant<>("root-rounded-down", "corner", EllipseMutants::roundedDown),
                new Mutant<>(
                        "rows-from-45-degrees-on", "corner", EllipseMutants::splitAtTheDiagonal));
    }

    interface PixelCondition {
        boolean test(int u, int v);
    }

    private static void keep(int x0, int y0, int a, int b, PixelCondition kept, Pixels out) {
        RIGHT.draw(
                x0,
                y0,
                a,
                b,
                (x, y) -> {
                    if (kept.test(Math.abs(x - x0), Math.abs(y - y0))) out.plot(x, y);
                });
    }

    /**
     * Draws in each column the pixels that are nearest to the curve above and below, and no others.
     */
    private static void columnsOnly(int x0, int y0, int a, int b, Pixels out) {
        for (int u = 0; u <= a; u++) {
            double share = a == 0 ? 0 : (double) u / a;
            int v = (int) Math.round(b * Math.sqrt(1 - share * share));
            for (int x : u == 0 ? new int[] {0} : new int[] {-u, u}) {
                out.plot(x0 + x, y0 - v);
                if (v > 0) out.plot(x0 + x, y0 + v);
            }
        }
    }

    private static void axesTwice(int x0, int y0, int a, int b, Pixels out) {
        RIGHT.draw(
                x0,
                y0,
                a,
                b,
                (x, y) -> {
                    out.plot(x, y);
                    if ((x == x0 || y == y0) && (a > 0 || b > 0)) out.plot(x, y);
                });
    }

    private static void roundedDown(int x0, int y0, int a, int b, Pixels out) {
        byBoth(x0, y0, a, b, Math::floor, (u, v) -> true, (u, v) -> true, out);
    }

    /** Takes columns where u is at most v and rows elsewhere, as on a circle. */
    private static void splitAtTheDiagonal(int x0, int y0, int a, int b, Pixels out) {
        byBoth(x0, y0, a, b, Math::rint, (u, v) -> u <= v, (u, v) -> v <= u, out);
    }

    static void byBoth(
            int x0,
            int y0,
            int a,
            int b,
            DoubleUnaryOperator rounding,
            PixelCondition columns,
            PixelCondition rows,
            Pixels out) {
        Mirror mirror = Mirror.about(x0, y0, a, b, out);
        var drawn = new HashSet<Long>();
        for (int u = 0; u <= a; u++) {
            int v = (int) rounding.applyAsDouble(b * root(u, a));
            if (columns.test(u, v) && drawn.add(((long) u << 32) + v)) mirror.four(u, v);
        }
        for (int v = 0; v <= b; v++) {
            int u = (int) rounding.applyAsDouble(a * root(v, b));
            if (rows.test(u, v) && drawn.add(((long) u << 32) + v)) mirror.four(u, v);
        }
    }

    private static double root(int part, int half) {
        double share = half == 0 ? 0 : (double) part / half;
        return Math.sqrt(1 - share * share);
    }
}
