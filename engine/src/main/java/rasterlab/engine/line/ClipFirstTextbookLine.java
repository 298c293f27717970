package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.clip.segment.LiangBarsky;
import rasterlab.engine.raster.PixelWindow;

/**
 * A line clipped to the window first, as a segment of real numbers, and then drawn between the
 * rounded new ends.
 *
 * <p>Rounding an end moves it off the line by up to half a pixel, so the slope changes: the drawn
 * line is turned and lights other pixels than the whole line lights there. Where the exact line
 * passes outside, up to half a pixel beside the window's outermost pixels, it is left out although
 * its pixels lie inside. {@link BresenhamLine} enters the window in the middle of its walk instead.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 4,
 * procedure CLIP, which ends by drawing the line between the clipped ends.
 */
public final class ClipFirstTextbookLine implements WindowedLine {
    private final BresenhamLine bresenham = new BresenhamLine();
    private final SegmentClipper clipper = new LiangBarsky();

    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        bresenham.draw(x0, y0, x1, y1, out);
    }

    @Override
    public LineWalk walk(int x0, int y0, int x1, int y1) {
        return bresenham.walk(x0, y0, x1, y1);
    }

    @Override
    public LineWalk walk(int x0, int y0, int x1, int y1, PixelWindow w) {
        LineWalk[] walk = {new BresenhamSection(x0, y0, LineSection.none())};
        clipper.clip(
                w.xmin(),
                w.ymin(),
                w.xmax(),
                w.ymax(),
                x0,
                y0,
                x1,
                y1,
                (fromX, fromY, toX, toY) -> walk[0] = rounded(fromX, fromY, toX, toY));
        return walk[0];
    }

    private LineWalk rounded(double fromX, double fromY, double toX, double toY) {
        return bresenham.walk(
                (int) Math.rint(fromX),
                (int) Math.rint(fromY),
                (int) Math.rint(toX),
                (int) Math.rint(toY));
    }

    @Override
    public String decisionFormula() {
        return bresenham.decisionFormula();
    }

    @Override
    public Decides decides() {
        return bresenham.decides();
    }

    @Override
    public LineWork work() {
        return bresenham.work();
    }
}
