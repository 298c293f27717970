package rasterlab.engine.line;

import rasterlab.contract.CoveragePixels;
import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * An anti-aliased line: each step lights the two pixels that the exact line passes between.
 *
 * <p>f is the signed distance across from the nearest pixel to the exact line, −½ ≤ f ≤ ½, in
 * pixels towards the side the line drifts to. The nearest pixel is covered by 1 − |f|, its
 * neighbour on f's side by |f|, so that every step sheds the same light whatever the slope. In
 * levels: ⌈255·|f| − ½⌉ for the neighbour, but at most 127, since on a tie f's rounding error may
 * carry 255·|f| − ½ beyond 127; and the rest of 255 for the nearest, which therefore has at least
 * 128.
 *
 * <p>The walk is {@link DdaLine}'s, with its bound of 2²⁴ steps: which pixel is nearest is exact, f
 * is right to 2⁻²⁷, a level to at most 1.
 *
 * <p>Source: X. Wu, An efficient antialiasing technique, Computer Graphics (SIGGRAPH) 25(4), 1991,
 * pp. 143–152.
 */
public final class WuLine implements CoverageLine {
    private final DdaLine dda = new DdaLine();

    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        dda.draw(x0, y0, x1, y1, out);
    }

    @Override
    public LineWalk walk(int x0, int y0, int x1, int y1) {
        return dda.walk(x0, y0, x1, y1);
    }

    @Override
    public String decisionFormula() {
        return dda.decisionFormula();
    }

    @Override
    public Decides decides() {
        return dda.decides();
    }

    /** The walk's, and the share of each pixel in two. */
    @Override
    public LineWork work() {
        LineWork walk = dda.work();
        return new LineWork(walk.start(), new Work(4, 1, 0, 1, 4), walk.across());
    }

    @Override
    public void shade(int x0, int y0, int x1, int y1, CoveragePixels out) {
        LineWalk walk = dda.walk(x0, y0, x1, y1);
        long dx = (long) x1 - x0;
        long dy = (long) y1 - y0;
        boolean steep = Math.abs(dy) > Math.abs(dx);
        int acrossX = steep ? Long.signum(dx) : 0;
        int acrossY = steep ? 0 : Long.signum(dy);
        double tie = DdaLine.tie(acrossX + acrossY, Math.max(Math.abs(dx), Math.abs(dy)));
        while (walk.advance()) {
            double f = walk.decision() - tie;
            int beside = Math.min(FULL / 2, (int) Math.ceil(FULL * Math.abs(f) - 0.5));
            int side = f < 0 ? -1 : 1;
            out.plot(walk.x(), walk.y(), FULL - beside);
            if (beside > 0) out.plot(walk.x() + side * acrossX, walk.y() + side * acrossY, beside);
        }
    }
}
