package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * The full version as printed, with its faults, kept to be looked at beside {@link BresenhamLine}.
 *
 * <p>Its counting loop begins one to the right of (or below) the first end even when it counts
 * down, so a line to the left or upward makes two steps too many and a single point becomes two. It
 * stays on the near side of a tie, so the two directions differ. It computes in int: differences
 * and their doubles overflow from 2³⁰ on, and a loop up to the largest int never ends.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, fig. 65.
 */
public final class BresenhamTextbookLine implements SteppedLine {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        var walk = new Walk(x0, y0, x1, y1);
        while (walk.advance()) out.plot(walk.x(), walk.y());
    }

    @Override
    public LineWalk walk(int x0, int y0, int x1, int y1) {
        return new Walk(x0, y0, x1, y1);
    }

    @Override
    public String decisionFormula() {
        return "d = 2·(i + 1)·b − (2·j + 1)·n in 32 bits; step across when d > 0";
    }

    @Override
    public Decides decides() {
        return Decides.NEXT_PIXEL;
    }

    @Override
    public LineWork work() {
        return new LineWork(new Work(5, 0, 0, 0, 3), new Work(1, 0, 0, 0, 1), Work.NONE);
    }

    private static final class Walk implements LineWalk {
        private final boolean steep;
        private final int end;
        private final int alongStep;
        private final int acrossStep;
        private final int straight;
        private final int diagonal;
        private int counter;
        private int along;
        private int across;
        private int d;
        private boolean begun;

        Walk(int x0, int y0, int x1, int y1) {
            int dx = Math.abs(x1 - x0);
            int dy = Math.abs(y1 - y0);
            int stepX = x0 < x1 ? 1 : -1;
            int stepY = y0 < y1 ? 1 : -1;
            steep = dy > dx;
            int n = steep ? dy : dx;
            along = steep ? y0 : x0;
            across = steep ? x0 : y0;
            end = steep ? y1 : x1;
            alongStep = steep ? stepY : stepX;
            acrossStep = steep ? stepX : stepY;
            straight = 2 * (steep ? dx : dy);
            d = straight - n;
            diagonal = d - n;
            counter = along + 1;
        }

        @Override
        public boolean advance() {
            if (!begun) {
                begun = true;
                return true;
            }
            if (alongStep > 0 ? counter > end : counter < end) return false;
            if (d > 0) {
                d += diagonal;
                across += acrossStep;
            } else {
                d += straight;
            }
            along = counter;
            counter += alongStep;
            return true;
        }

        @Override
        public int x() {
            return steep ? across : along;
        }

        @Override
        public int y() {
            return steep ? along : across;
        }

        @Override
        public double decision() {
            return d;
        }
    }
}
