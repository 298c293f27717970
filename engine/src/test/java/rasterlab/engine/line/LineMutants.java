package rasterlab.engine.line;

import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Mutants;

/** Segments drawn with one mistake. */
final class LineMutants implements Mutants<LineRasterizer> {
    private static final LineRasterizer RIGHT = new BresenhamLine();

    @Override
    public List<Mutant<LineRasterizer>> all() {
        return List.of(
                new Mutant<>("the last pixel is left out", "both-ends", LineMutants::withoutLast),
                new Mutant<>("the first pixel is left out", "both-ends", LineMutants::withoutFirst),
                new Mutant<>("ties go to the larger row", "ties", LineMutants::tiesDown),
                new Mutant<>(
                        "drawn from the left end whatever was asked",
                        "leftward",
                        (x0, y0, x1, y1, out) -> {
                            if (x0 <= x1) RIGHT.draw(x0, y0, x1, y1, out);
                            else RIGHT.draw(x1, y1, x0, y0, out);
                        }),
                new Mutant<>("one pixel a column", "steep", LineMutants::byColumns),
                new Mutant<>(
                        "rows only grow",
                        "upward",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(x0, y0, x1, y0 + Math.abs(y1 - y0), out)),
                new Mutant<>(
                        "a single point is skipped",
                        "single-point",
                        (x0, y0, x1, y1, out) -> {
                            if (x0 != x1 || y0 != y1) RIGHT.draw(x0, y0, x1, y1, out);
                        }),
                new Mutant<>(
                        "products in 32 bits", "products-beyond-int", LineMutants::productsInInt),
                new Mutant<>("slope in 16.16 bits", "long", LineMutants::fixedPoint),
                new Mutant<>(
                        "coordinates pass through floats",
                        "far-away",
                        (x0, y0, x1, y1, out) ->
                                RIGHT.draw(
                                        (int) (float) x0,
                                        (int) (float) y0,
                                        (int) (float) x1,
                                        (int) (float) y1,
                                        out)));
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

    /** Right for 0 ≤ y1 − y0 ≤ x1 − x0 as long as no product overflows. */
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

    private static void fixedPoint(int x0, int y0, int x1, int y1, Pixels out) {
        int n = x1 - x0;
        int b = y1 - y0;
        if (b < 0 || b > n || n == 0 || n > 1 << 20) {
            RIGHT.draw(x0, y0, x1, y1, out);
            return;
        }
        long slope = ((long) b << 16) / n;
        long y = ((long) y0 << 16) + (1 << 15) - 1;
        for (int i = 0; i <= n; i++, y += slope) out.plot(x0 + i, (int) (y >> 16));
    }

    /** The mirror image of a line's mirror image, whose ties go the other way. */
    private static void tiesDown(int x0, int y0, int x1, int y1, Pixels out) {
        RIGHT.draw(-x0, -y0, -x1, -y1, (x, y) -> out.plot(-x, -y));
    }

    /** Above 45° only the first pixel that a column has. */
    private static void byColumns(int x0, int y0, int x1, int y1, Pixels out) {
        var last = new long[] {Long.MIN_VALUE};
        RIGHT.draw(
                x0,
                y0,
                x1,
                y1,
                (x, y) -> {
                    if (x != last[0]) out.plot(x, y);
                    last[0] = x;
                });
    }
}
