package rasterlab.engine.circle;

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
                new Mutant<>("diagonals-left-out", "corner", CircleMutants::withoutCorner));
    }

    private static void axesTwice(int centreX, int centreY, int radius, Pixels out) {
        RIGHT.draw(
                centreX,
                centreY,
                radius,
                (x, y) -> {
                    out.plot(x, y);
                    if (radius > 0 && (x == centreX || y == centreY)) out.plot(x, y);
                });
    }

    private static void cornerTwice(int centreX, int centreY, int radius, Pixels out) {
        RIGHT.draw(
                centreX,
                centreY,
                radius,
                (x, y) -> {
                    out.plot(x, y);
                    if (radius > 0 && Math.abs(x - centreX) == Math.abs(y - centreY))
                        out.plot(x, y);
                });
    }

    private static void withoutCorner(int centreX, int centreY, int radius, Pixels out) {
        RIGHT.draw(
                centreX,
                centreY,
                radius,
                (x, y) -> {
                    if (radius == 0 || Math.abs(x - centreX) != Math.abs(y - centreY))
                        out.plot(x, y);
                });
    }

    /** Draws an octant by the root that gives the row for a column, and mirrors it. */
    private static CircleRasterizer byRoots(IntBinaryOperator root) {
        return (centreX, centreY, radius, out) -> {
            Mirror mirror = Mirror.about(centreX, centreY, radius, radius, out);
            for (int u = 0; ; u++) {
                int v = root.applyAsInt(radius, u);
                if (u > v) return;
                mirror.eight(u, v);
            }
        };
    }
}
