package rasterlab.engine.line;

import rasterlab.engine.raster.PixelWindow;

/** A method that enters a window directly, however far outside the line begins. */
public interface WindowedLine extends SteppedLine {
    /**
     * A walk over those pixels of the line that lie in the window: a right method passes the same
     * ones there as in the whole walk, in the same order and with the same decision values.
     */
    LineWalk walk(int x0, int y0, int x1, int y1, PixelWindow window);
}
