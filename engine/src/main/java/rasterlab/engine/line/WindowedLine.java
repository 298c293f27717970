package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.contract.WindowedLineRasterizer;
import rasterlab.engine.raster.PixelWindow;

/** A method that enters a window directly, however far outside the line begins. */
public interface WindowedLine extends SteppedLine, WindowedLineRasterizer {
    /**
     * A walk over those pixels of the line that lie in the window: a right method passes the same
     * ones there as in the whole walk, in the same order and with the same decision values.
     */
    LineWalk walk(int x0, int y0, int x1, int y1, PixelWindow window);

    @Override
    default void draw(
            int x0, int y0, int x1, int y1, int xmin, int ymin, int xmax, int ymax, Pixels out) {
        LineWalk walk = walk(x0, y0, x1, y1, new PixelWindow(xmin, ymin, xmax, ymax));
        while (walk.advance()) out.plot(walk.x(), walk.y());
    }
}
