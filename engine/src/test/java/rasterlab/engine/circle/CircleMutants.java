package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Mutants;

/** Circles drawn with one mistake. */
final class CircleMutants implements Mutants<CircleRasterizer> {
    private static final CircleRasterizer RIGHT = new MidpointCircle();

    @Override
    public List<Mutant<CircleRasterizer>> all() {
        return List.of(
                new Mutant<>("pixels on an axis come twice", "radius-1", CircleMutants::axesTwice),
                new Mutant<>(
                        "pixels on a diagonal come twice", "corner", CircleMutants::cornerTwice),
                new Mutant<>(
                        "a radius of 0 draws nothing",
                        "radius-0",
                        (x, y, r, out) -> {
                            if (r > 0) RIGHT.draw(x, y, r, out);
                        }),
                new Mutant<>(
                        "the centre's column and row are swapped",
                        "off-the-diagonal",
                        (x, y, r, out) -> RIGHT.draw(y, x, r, out)),
                new Mutant<>(
                        "the row below √(r² − u²)", "crowded-columns", CircleMutants::roundedDown),
                new Mutant<>(
                        "squares in 32 bits",
                        "squares-beyond-int",
                        (x, y, r, out) -> {
                            if (r * r >= 0) RIGHT.draw(x, y, r, out);
                        }),
                new Mutant<>(
                        "u ≤ v is u < v: the diagonal is left out",
                        "corner",
                        CircleMutants::withoutCorner));
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

    private static void roundedDown(int centreX, int centreY, int radius, Pixels out) {
        Mirror mirror = Mirror.about(centreX, centreY, radius, radius, out);
        for (int u = 0; ; u++) {
            int v = (int) Math.sqrt((double) radius * radius - (double) u * u);
            if (u > v) return;
            mirror.four(u, v);
            if (u != v) mirror.four(v, u);
        }
    }
}
