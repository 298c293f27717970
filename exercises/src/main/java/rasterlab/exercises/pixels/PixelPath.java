package rasterlab.exercises.pixels;

import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelRecording;

/** The right pixels of an input, in their order from one end to the other. */
public interface PixelPath {
    Pixel first();

    Pixel last();

    /** The exact pixels, at most so many of the first ones. */
    PixelRecording exact(int limit);

    /**
     * The path with tied pixels as another answer has them: where two pixels are as near to what is
     * to be drawn, that answer's own.
     */
    PixelRecording nearest(PixelRecording actual, int limit);

    /** The path of the same kind between other ends. */
    PixelPath between(Pixel from, Pixel to);

    /** The path from the last end to the first. */
    default PixelPath reversed() {
        return between(last(), first());
    }
}
