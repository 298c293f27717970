package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * The first version as printed: for lines to the right, upward in value, up to 45°, and for no
 * others.
 *
 * <p>It counts columns from X1 + 1 to X2 and only ever adds 1 to Y. A steep line has one pixel per
 * column and so gaps; a line to the left ends with its first pixel; where the row should fall it
 * stays or rises. It stays on the near side of a tie. Differences and their doubles overflow an int
 * from 2³⁰ on, and a loop up to the largest int never ends.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, fig. 63; that
 * it leaves gaps and knows one direction is said there too (fig. 64).
 */
public final class BresenhamFirstTextbookLine implements SteppedLine {
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
        return "D = 2·(i + 1)·dy − (2·j + 1)·dx in 32 bits; Y ← Y + 1 when D > 0";
    }

    @Override
    public Decides decides() {
        return Decides.NEXT_PIXEL;
    }

    @Override
    public LineWork work() {
        return new LineWork(new Work(5, 0, 0, 0, 0), new Work(1, 0, 0, 0, 1), Work.NONE);
    }

    private static final class Walk implements LineWalk {
        private final int last;
        private final int straight;
        private final int diagonal;
        private int counter;
        private int x;
        private int y;
        private int d;
        private boolean begun;

        Walk(int x0, int y0, int x1, int y1) {
            int dx = x1 - x0;
            int dy = y1 - y0;
            straight = dy + dy;
            d = straight - dx;
            diagonal = d - dx;
            x = x0;
            y = y0;
            counter = x0 + 1;
            last = x1;
        }

        @Override
        public boolean advance() {
            if (!begun) {
                begun = true;
                return true;
            }
            if (counter > last) return false;
            if (d > 0) {
                d += diagonal;
                y++;
            } else {
                d += straight;
            }
            x = counter++;
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
