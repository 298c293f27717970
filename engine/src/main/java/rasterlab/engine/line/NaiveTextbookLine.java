package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * Y = K·(X − X1) + Y1 for each column from the first to the last, with the listing's faults.
 *
 * <p>One pixel per column leaves gaps above 45°; counting up draws nothing to the left; a vertical
 * line divides by zero and lands in row 0; ties go to the larger row; the differences overflow an
 * int, and a loop up to the largest int never ends.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, fig. 59; it
 * leaves the rounding to the procedure that lights the pixel, and says so.
 */
public final class NaiveTextbookLine implements SteppedLine {
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
        return "K·(X − X1) + Y1, rounded to the nearest row";
    }

    @Override
    public Decides decides() {
        return Decides.THIS_PIXEL;
    }

    @Override
    public LineWork work() {
        return new LineWork(new Work(2, 0, 1, 0, 0), new Work(2, 1, 0, 1, 0), Work.NONE);
    }

    private static final class Walk implements LineWalk {
        private final double k;
        private final int x0;
        private final int y0;
        private final int last;
        private int x;
        private int y;
        private double exactY;

        Walk(int x0, int y0, int x1, int y1) {
            k = (double) (y1 - y0) / (x1 - x0);
            this.x0 = x0;
            this.y0 = y0;
            last = x1;
            x = x0 - 1;
        }

        @Override
        public boolean advance() {
            int next = x + 1;
            if (next > last) return false;
            x = next;
            exactY = k * (x - x0) + y0;
            y = (int) Math.round(exactY);
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
            return exactY;
        }
    }
}
