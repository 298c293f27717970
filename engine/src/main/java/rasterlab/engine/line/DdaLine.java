package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * The digital differential analyser: one floating-point addition per pixel, and still exact.
 *
 * <p>Only f is kept, how far the exact line lies beside the current pixel in the direction it
 * drifts to, −½ ≤ f &lt; ½; it grows by k = b/n and loses a whole pixel whenever the line steps
 * across. It starts at −1/(4·n) where the coordinate across grows and at +1/(4·n) where it falls:
 * exact positions are multiples of 1/n, so a tie goes to the smaller coordinate and every decision
 * has a margin of 1/(4·n). One addition errs by at most 2⁻⁵³, k by 2⁻⁵⁴, and taking off a whole
 * pixel is exact (P. H. Sterbenz, Floating-Point Computation, 1974), so n + 1 additions err by less
 * than 2·(n + 1)·2⁻⁵³ ≤ 2⁻²⁷ for n ≤ 2²⁴, less than the margin, which is at least 2⁻²⁶: rounding
 * never decides. Longer lines are refused. The walk begins one step before the first end.
 */
public final class DdaLine implements SteppedLine {
    /** The largest n, in steps along the longer axis, for which the result is proved exact. */
    public static final int MOST_STEPS = 1 << 24;

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
        return "f ← f + k; step across and take 1 off when f ≥ ½; begins at ∓1/(4·n)";
    }

    @Override
    public Decides decides() {
        return Decides.NEXT_PIXEL;
    }

    @Override
    public LineWork work() {
        return new LineWork(
                new Work(3, 0, 2, 0, 4), new Work(1, 0, 0, 0, 1), new Work(1, 0, 0, 0, 0));
    }

    /**
     * The value of f at the first end instead of 0, so that a tie goes to the smaller coordinate.
     *
     * @param direction of the coordinate across, −1 where it falls
     * @param n steps along the longer axis
     */
    static double tie(int direction, long n) {
        if (n == 0) return 0;
        return (direction < 0 ? 0.25 : -0.25) / n;
    }

    private static final class Walk implements LineWalk {
        private final int alongX;
        private final int alongY;
        private final int acrossX;
        private final int acrossY;
        private final double k;
        private int x;
        private int y;
        private double f;
        private int left;

        Walk(int x0, int y0, int x1, int y1) {
            long dx = (long) x1 - x0;
            long dy = (long) y1 - y0;
            boolean steep = Math.abs(dy) > Math.abs(dx);
            int n = ProvedSteps.checked(Math.abs(steep ? dy : dx), MOST_STEPS);
            alongX = steep ? 0 : Long.signum(dx);
            alongY = steep ? Long.signum(dy) : 0;
            acrossX = steep ? Long.signum(dx) : 0;
            acrossY = steep ? 0 : Long.signum(dy);
            k = n == 0 ? 0 : (double) Math.abs(steep ? dx : dy) / n;
            f = tie(acrossX + acrossY, n) - k;
            x = x0 - alongX;
            y = y0 - alongY;
            left = n + 1;
        }

        @Override
        public boolean advance() {
            if (left == 0) return false;
            left--;
            f += k;
            if (f >= 0.5) {
                f--;
                x += acrossX;
                y += acrossY;
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
            return f;
        }
    }
}
