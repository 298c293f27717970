package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * The digital differential analyser as it is usually written: both coordinates in floats.
 *
 * <p>Each step adds dx/n to x and dy/n to y and rounds both to the nearest pixel, a half to the
 * smaller. A float has 24 bits: each addition errs by up to 2⁻²⁵ of the coordinate, the errors add
 * up, and the line leaves its course (after n steps at coordinates about n by up to n²·2⁻²⁵
 * pixels); from 2²⁴ on not every pixel has a float and the line stands still. {@link DdaLine} shows
 * what it takes to be exact.
 *
 * <p>Sources: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch.
 * 4; J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics: Principles and
 * Practice, 1990, section 3.2.1.
 */
public final class FloatDdaLine implements SteppedLine {
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
        return "the coordinate across before it is rounded";
    }

    @Override
    public Decides decides() {
        return Decides.THIS_PIXEL;
    }

    @Override
    public LineWork work() {
        return new LineWork(new Work(4, 0, 2, 0, 1), new Work(2, 0, 0, 2, 0), Work.NONE);
    }

    private static final class Walk implements LineWalk {
        private final boolean steep;
        private final float stepX;
        private final float stepY;
        private float x;
        private float y;
        private long left;

        Walk(int x0, int y0, int x1, int y1) {
            long dx = (long) x1 - x0;
            long dy = (long) y1 - y0;
            steep = Math.abs(dy) > Math.abs(dx);
            long n = Math.max(Math.abs(dx), Math.abs(dy));
            stepX = n == 0 ? 0 : (float) dx / n;
            stepY = n == 0 ? 0 : (float) dy / n;
            x = x0 - stepX;
            y = y0 - stepY;
            left = n + 1;
        }

        @Override
        public boolean advance() {
            if (left == 0) return false;
            left--;
            x += stepX;
            y += stepY;
            return true;
        }

        @Override
        public int x() {
            return nearest(x);
        }

        @Override
        public int y() {
            return nearest(y);
        }

        @Override
        public double decision() {
            return steep ? x : y;
        }

        private static int nearest(float coordinate) {
            return (int) Math.ceil(coordinate - 0.5f);
        }
    }
}
