package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * The equation of the line, evaluated and rounded at every step along its longer axis.
 *
 * <p>Across the longer axis the line has moved v = k·i after i steps, |k| ≤ 1, and the pixel is ⌊v
 * + ½ − 1/(4·n)⌋ from the start: a tie goes to the smaller coordinate. An exact v is a multiple of
 * 1/n, so v + ½ − 1/(4·n) is at least 1/(4·n) away from any whole number. For n ≤ 2²⁴ the slope's
 * error times i and the product's rounding are each at most 2⁻³⁰, the sum's, which may pass 2²⁴, at
 * most 2⁻²⁹ and the offset's far less: together below 2⁻²⁷, while 1/(4·n) ≥ 2⁻²⁶. So rounding never
 * decides. Longer lines are refused.
 */
public final class NaiveLine implements SteppedLine {
    /** The largest n, in steps along the longer axis, for which the result is proved exact. */
    public static final int MOST_STEPS = 1 << 24;

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
        return "s + k·i, the coordinate across before rounding; a half goes to the smaller";
    }

    @Override
    public Decides decides() {
        return Decides.THIS_PIXEL;
    }

    @Override
    public LineWork work() {
        return new LineWork(new Work(3, 0, 2, 0, 2), new Work(2, 1, 0, 1, 0), Work.NONE);
    }

    private static final class Walk implements LineWalk {
        private final boolean steep;
        private final int startAlong;
        private final int startAcross;
        private final int step;
        private final int n;
        private final double k;
        private final double offset;
        private int i = -1;
        private int across;

        Walk(int x0, int y0, int x1, int y1) {
            long dx = (long) x1 - x0;
            long dy = (long) y1 - y0;
            steep = Math.abs(dy) > Math.abs(dx);
            long extent = steep ? dy : dx;
            n = ProvedSteps.checked(Math.abs(extent), MOST_STEPS);
            startAlong = steep ? y0 : x0;
            startAcross = steep ? x0 : y0;
            step = extent < 0 ? -1 : 1;
            k = n == 0 ? 0 : (double) (steep ? dx : dy) / n;
            offset = n == 0 ? 0 : 0.5 - 0.25 / n;
        }

        @Override
        public boolean advance() {
            if (i == n) return false;
            i++;
            across = startAcross + (int) Math.floor(k * i + offset);
            return true;
        }

        @Override
        public int x() {
            return steep ? across : startAlong + step * i;
        }

        @Override
        public int y() {
            return steep ? startAlong + step * i : across;
        }

        @Override
        public double decision() {
            return startAcross + k * i;
        }
    }
}
