package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Mutants;

/** Ellipses drawn with one mistake. */
final class EllipseMutants implements Mutants<EllipseRasterizer> {
    private static final EllipseRasterizer RIGHT = new MidpointEllipse();

    @Override
    public List<Mutant<EllipseRasterizer>> all() {
        return List.of(
                new Mutant<>(
                        "half-axes are swapped",
                        "very-flat",
                        (x, y, a, b, out) -> RIGHT.draw(x, y, b, a, out)),
                new Mutant<>(
                        "ends where row 0 is reached",
                        "very-flat",
                        (x, y, a, b, out) -> keep(x, y, a, b, (u, v) -> v > 0 || b == 0, out)),
                new Mutant<>(
                        "ends where column 0 is left",
                        "very-tall",
                        (x, y, a, b, out) -> keep(x, y, a, b, (u, v) -> u > 0 || a == 0, out)),
                new Mutant<>(
                        "one row for each column and no more",
                        "corner",
                        EllipseMutants::columnsOnly),
                new Mutant<>(
                        "without extent it draws nothing",
                        "point",
                        (x, y, a, b, out) -> {
                            if (a > 0 || b > 0) RIGHT.draw(x, y, a, b, out);
                        }),
                new Mutant<>(
                        "F in 32 bits",
                        "products-beyond-int",
                        (x, y, a, b, out) -> {
                            if ((long) a * a * b == (int) ((long) a * a * b))
                                RIGHT.draw(x, y, a, b, out);
                        }),
                new Mutant<>(
                        "a half-axis of 0 is taken for none",
                        "upright-line",
                        (x, y, a, b, out) -> {
                            if (a > 0 || b == 0) RIGHT.draw(x, y, a, b, out);
                        }));
    }

    private interface Kept {
        boolean test(int u, int v);
    }

    private static void keep(int x0, int y0, int a, int b, Kept kept, Pixels out) {
        RIGHT.draw(
                x0,
                y0,
                a,
                b,
                (x, y) -> {
                    if (kept.test(Math.abs(x - x0), Math.abs(y - y0))) out.plot(x, y);
                });
    }

    private static void columnsOnly(int x0, int y0, int a, int b, Pixels out) {
        var rows = new int[a + 1];
        new ExactEllipse(a, b).quadrant((u, v) -> rows[u] = Math.max(rows[u], v));
        keep(x0, y0, a, b, (u, v) -> v == rows[u], out);
    }
}
