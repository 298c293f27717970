package rasterlab.engine.line;

import rasterlab.contract.Pixels;

/**
 * y = k·x + b for each column from the first to the last, with the faults of the course's first
 * version.
 *
 * <p>One pixel per column leaves gaps above 45°; counting up draws nothing to the left; a vertical
 * line divides by zero and lands in row 0; ties go to the larger row; the differences overflow an
 * int, and a loop up to the largest int never ends.
 *
 * <p>Source: the course's lecture texts on raster algorithms, first listing.
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
        return "k·x + b, rounded to the nearest row";
    }

    private static final class Walk implements LineWalk {
        private final double k;
        private final double b;
        private final int last;
        private int x;
        private int y;

        Walk(int x0, int y0, int x1, int y1) {
            k = (double) (y1 - y0) / (x1 - x0);
            b = y0 - k * x0;
            last = x1;
            x = x0 - 1;
        }

        @Override
        public boolean advance() {
            int next = x + 1;
            if (next > last) return false;
            x = next;
            y = (int) Math.round(k * x + b);
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
            return k * x + b;
        }
    }
}
