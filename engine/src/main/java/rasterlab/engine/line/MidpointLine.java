package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.raster.Work;

/**
 * A straight line by the side on which the middle between two candidates lies.
 *
 * <p>With u pixels along and v across counted from the start, F(u, v) = 2·(b·u − n·v) is 0 on the
 * line and positive on the side towards the axis along. The next pixel is (u + 1, v) or (u + 1, v +
 * 1), and the middle between them is M = (u + 1, v + ½): F(M) = 2·b·(u + 1) − n·(2·v + 1). Where
 * F(M) &gt; 0 the line passes beyond M, so step across. A step along adds 2·b to F(M), one across
 * takes 2·n off. Where F(M) = 0 the line hits M, and the pixel with the smaller coordinate is lit.
 *
 * <p>|F(M)| ≤ 2·n &lt; 2³³ for int ends, so a long never overflows.
 *
 * <p>Source: M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a digital
 * plotter, Computer Journal 10(3), 1967, pp. 282–289.
 */
public final class MidpointLine implements WindowedLine {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        var walk = new Walk(x0, y0, LineSection.whole(x0, y0, x1, y1));
        while (walk.advance()) out.plot(walk.x, walk.y);
    }

    @Override
    public LineWalk walk(int x0, int y0, int x1, int y1) {
        return new Walk(x0, y0, LineSection.whole(x0, y0, x1, y1));
    }

    @Override
    public LineWalk walk(int x0, int y0, int x1, int y1, PixelWindow window) {
        return new Walk(x0, y0, LineSection.within(window, x0, y0, x1, y1));
    }

    @Override
    public String decisionFormula() {
        return "F(M) = 2·b·(u + 1) − n·(2·v + 1); step across when F(M) > 0, or when it is 0 and the"
                + " coordinate across falls";
    }

    @Override
    public Decides decides() {
        return Decides.NEXT_PIXEL;
    }

    @Override
    public LineWork work() {
        return new LineWork(
                new Work(7, 0, 0, 0, 4), new Work(1, 0, 0, 0, 1), new Work(1, 0, 0, 0, 0));
    }

    private static final class Walk implements LineWalk {
        private final boolean steep;
        private final int signX;
        private final int signY;
        private final long along;
        private final long across;
        private final int leastAcross;
        private int x;
        private int y;
        private long atMiddle;
        private long left;

        Walk(int x0, int y0, LineSection section) {
            steep = section.steep();
            signX = section.signX();
            signY = section.signY();
            along = 2 * section.b();
            across = 2 * section.n();
            leastAcross = section.tie();
            x = section.x(x0) - (steep ? 0 : signX);
            y = section.y(y0) - (steep ? signY : 0);
            atMiddle = section.remainder() + section.tie() - across;
            left = section.count();
        }

        @Override
        public boolean advance() {
            if (left == 0) return false;
            left--;
            boolean stepsAcross = atMiddle >= leastAcross;
            atMiddle += along;
            if (stepsAcross) atMiddle -= across;
            if (stepsAcross || !steep) x += signX;
            if (stepsAcross || steep) y += signY;
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
            return atMiddle;
        }
    }
}
