package rasterlab.engine.circle;

import java.util.HashSet;
import java.util.List;
import java.util.function.IntBinaryOperator;
import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.study.Mutant;

/** Circles drawn with one mistake. */
final class CircleMutants {
    private static final CircleRasterizer RIGHT = new MidpointCircle();

    private CircleMutants() {}

    static List<Mutant<CircleRasterizer>> all() {
        return List.of(
                new Mutant<>("axes-twice", "radius-1", CircleMutants::axesTwice),
                new Mutant<>("diagonals-twice", "corner", CircleMutants::cornerTwice),
                new Mutant<>(
                        "radius-0-skipped",
                        "radius-0",
                        (x, y, r, out) -> {
                            if (r > 0) RIGHT.draw(x, y, r, out);
                        }),
                new Mutant<>(
                        "x-y-swapped",
                        "off-the-diagonal",
                        (x, y, r, out) -> RIGHT.draw(y, x, r, out)),
                new Mutant<>(
                        "root-rounded-down",
                        "crowded-columns",
                        byRoots((r, u) -> (int) Math.sqrt((double) r * r - (double) u * u))),
                new Mutant<>(
                        "squares-in-int",
                        "squares-beyond-int",
                        byRoots((r, u) -> (int) Math.rint(Math.sqrt(r * r - u * u)))),
                new Mutant<>("diagonals-left-out", "corner", CircleMutants::withoutCorner),
                new Mutant<>(
                        "center-ignored",
                        "off-the-diagonal",
                        (x, y, r, out) -> RIGHT.draw(0, 0, r, out)),
                new Mutant<>("columns-only", "crowded-columns", CircleMutants::columnsOnly),
                new Mutant<>("four-octants-only", "crowded-columns", CircleMutants::fourOctants),
                new Mutant<>(
                        "quarter-only",
                        "off-the-diagonal",
                        (x, y, r, out) ->
                                RIGHT.draw(
                                        x,
                                        y,
                                        r,
                                        (px, py) -> {
                                            if (px >= x && py >= y) out.plot(px, py);
                                        })),
                new Mutant<>("steps-of-one-degree", "crowded-columns", CircleMutants::byDegrees),
                new Mutant<>(
                        "decided-after-the-step", "off-the-diagonal", CircleMutants::afterTheStep));
    }

    private static void axesTwice(int centerX, int centerY, int radius, Pixels out) {
        RIGHT.draw(
                centerX,
                centerY,
                radius,
                (x, y) -> {
                    out.plot(x, y);
                    if (radius > 0 && (x == centerX || y == centerY)) out.plot(x, y);
                });
    }

    private static void cornerTwice(int centerX, int centerY, int radius, Pixels out) {
        RIGHT.draw(
                centerX,
                centerY,
                radius,
                (x, y) -> {
                    out.plot(x, y);
                    if (radius > 0 && Math.abs(x - centerX) == Math.abs(y - centerY))
                        out.plot(x, y);
                });
    }

    private static void withoutCorner(int centerX, int centerY, int radius, Pixels out) {
        RIGHT.draw(
                centerX,
                centerY,
                radius,
                (x, y) -> {
                    if (radius == 0 || Math.abs(x - centerX) != Math.abs(y - centerY))
                        out.plot(x, y);
                });
    }

    /** Draws an octant by the root that gives the row for a column, and mirrors it. */
    static CircleRasterizer byRoots(IntBinaryOperator root) {
        return (centerX, centerY, radius, out) -> {
            Mirror mirror = Mirror.about(centerX, centerY, radius, radius, out);
            for (int u = 0; ; u++) {
                int v = root.applyAsInt(radius, u);
                if (u > v) return;
                mirror.eight(u, v);
            }
        };
    }

    private static void columnsOnly(int centerX, int centerY, int radius, Pixels out) {
        Mirror mirror = Mirror.about(centerX, centerY, radius, radius, out);
        for (int u = 0; u <= radius; u++) {
            double square = (double) radius * radius - (double) u * u;
            mirror.four(u, (int) Math.rint(Math.sqrt(square)));
        }
    }

    /** Leaves out the mirror images across the diagonals. */
    private static void fourOctants(int centerX, int centerY, int radius, Pixels out) {
        RIGHT.draw(
                centerX,
                centerY,
                radius,
                (x, y) -> {
                    if (Math.abs(x - centerX) <= Math.abs(y - centerY)) out.plot(x, y);
                });
    }

    private static void byDegrees(int centerX, int centerY, int radius, Pixels out) {
        var drawn = new HashSet<List<Integer>>();
        for (int degree = 0; degree < 360; degree++) {
            double angle = Math.toRadians(degree);
            int x = (int) Math.round(centerX + radius * Math.cos(angle));
            int y = (int) Math.round(centerY + radius * Math.sin(angle));
            if (drawn.add(List.of(x, y))) out.plot(x, y);
        }
    }

    /**
     * The decision of Bresenham's textbook form, with the place after the step in place of before.
     */
    private static void afterTheStep(int centerX, int centerY, int radius, Pixels out) {
        Mirror mirror = Mirror.about(centerX, centerY, radius, radius, out);
        int v = radius;
        int decision = 3 - 2 * radius;
        for (int u = 0; u <= v; ) {
            mirror.eight(u, v);
            u++;
            if (decision > 0) {
                v--;
                decision += 4 * (u - v) + 10;
            } else decision += 4 * u + 6;
        }
    }
}
