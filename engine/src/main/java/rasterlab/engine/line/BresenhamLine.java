package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.raster.Work;

/**
 * A straight line in integers only, right for every pair of int ends.
 *
 * <p>With n and b the extents along the longer and the shorter axis, i and j the steps made along
 * and across, and t = 1 where the shorter axis's coordinate does not fall, else 0: {@code d = 2·(i
 * + 1)·b − (2·j + 1)·n − t}, twice n times how far the exact line will have passed the middle
 * between the two candidates, t sending a tie to the smaller coordinate. Step across when d ≥ 0.
 *
 * <p>At every pixel 2·b − 2·n ≤ d &lt; 2·b where n ≥ 1 (d = −1 for a single point), and n &lt; 2³²
 * for int ends, so a long never overflows (an int would from n = 2³⁰ on). The walk begins one step
 * along before its first pixel, where i = −1 and j = 0, so with d = −n − t.
 *
 * <p>Source: J. E. Bresenham, Algorithm for computer control of a digital plotter, IBM Systems
 * Journal 4(1), 1965, pp. 25–30.
 */
public final class BresenhamLine implements WindowedLine {
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
    public LineWalk walk(int x0, int y0, int x1, int y1, PixelWindow window) {
        return new BresenhamSection(x0, y0, LineSection.within(window, x0, y0, x1, y1));
    }

    @Override
    public String decisionFormula() {
        return "d = 2·(i + 1)·b − (2·j + 1)·n − t; step across when d ≥ 0";
    }

    @Override
    public Decides decides() {
        return Decides.NEXT_PIXEL;
    }

    @Override
    public LineWork work() {
        return new LineWork(new Work(8, 0, 0, 0, 4), new Work(1, 0, 0, 0, 1), Work.NONE);
    }

    private static final class Walk implements LineWalk {
        private final int alongX;
        private final int alongY;
        private final int acrossX;
        private final int acrossY;

        /** Change of d by a step along: 2·b. */
        private final long straight;

        /** Change of d by a step along and across: 2·b − 2·n. */
        private final long diagonal;

        private int x;
        private int y;
        private long d;
        private long left;

        Walk(int x0, int y0, int x1, int y1) {
            long dx = Math.abs((long) x1 - x0);
            long dy = Math.abs((long) y1 - y0);
            int signX = x1 < x0 ? -1 : 1;
            int signY = y1 < y0 ? -1 : 1;
            boolean steep = dy > dx;
            alongX = steep ? 0 : signX;
            alongY = steep ? signY : 0;
            acrossX = signX - alongX;
            acrossY = signY - alongY;
            long n = Math.max(dx, dy);
            long b = Math.min(dx, dy);
            int t = acrossX + acrossY > 0 ? 1 : 0;
            straight = 2 * b;
            diagonal = straight - 2 * n;
            x = x0 - alongX;
            y = y0 - alongY;
            d = -n - t;
            left = n + 1;
        }

        @Override
        public boolean advance() {
            if (left == 0) return false;
            left--;
            if (d >= 0) {
                d += diagonal;
                x += acrossX;
                y += acrossY;
            } else {
                d += straight;
            }
            x += alongX;
            y += alongY;
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
