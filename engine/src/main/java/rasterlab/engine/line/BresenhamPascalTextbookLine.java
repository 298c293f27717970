package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * The Pascal procedure as printed, whose row only grows.
 *
 * <p>It takes the absolute differences and begins at the left end, but adds 1 to y wherever it
 * steps across, so a line that should fall rises. It counts columns only, so a steep line has gaps
 * and a vertical one is its first pixel alone. On a tie it takes the larger row. 2·dx overflows an
 * int from 2³⁰ on (an integer of 16 bits from 2¹⁴ on).
 *
 * <p>The listing lights the pixel after the end of its loop, which would leave only two pixels of
 * any line; it also has one {@code end} too many there, and a comment says that this one ends the
 * loop. It is read so: the pixel is lit in the loop.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 4,
 * procedure Bresenham.
 */
public final class BresenhamPascalTextbookLine implements SteppedLine {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        var walk = new Walk(x0, y0, x1, y1);
        while (walk.advance()) out.plot(walk.x, walk.y);
    }

    @Override
    public LineWalk walk(int x0, int y0, int x1, int y1) {
        return new Walk(x0, y0, x1, y1);
    }

    @Override
    public String decisionFormula() {
        return "d = 2·(i + 1)·dy − (2·j + 1)·dx in 32 bits; y ← y + 1 when d ≥ 0";
    }

    @Override
    public Decides decides() {
        return Decides.NEXT_PIXEL;
    }

    @Override
    public LineWork work() {
        return new LineWork(new Work(7, 0, 0, 0, 1), new Work(1, 0, 0, 0, 1), Work.NONE);
    }

    private static final class Walk implements LineWalk {
        private final int last;
        private final int straight;
        private final int diagonal;
        private int x;
        private int y;
        private int d;
        private boolean begun;

        Walk(int x0, int y0, int x1, int y1) {
            int dx = Math.abs(x1 - x0);
            int dy = Math.abs(y1 - y0);
            d = 2 * dy - dx;
            straight = 2 * dy;
            diagonal = 2 * (dy - dx);
            boolean leftward = x0 > x1;
            x = leftward ? x1 : x0;
            y = leftward ? y1 : y0;
            last = leftward ? x0 : x1;
        }

        @Override
        public boolean advance() {
            if (!begun) {
                begun = true;
                return true;
            }
            if (x >= last) return false;
            x++;
            if (d < 0) {
                d += straight;
            } else {
                y++;
                d += diagonal;
            }
            return true;
        }

        @Override
        public int x() {
            return x;
        }

        @Override
        public int y() {
            return y;
        }

        @Override
        public double decision() {
            return d;
        }
    }
}
