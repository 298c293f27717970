package rasterlab.app.plan.least;

import rasterlab.engine.range.Bounds;
import rasterlab.engine.raster.Raster;

/**
 * The difference of two pictures, channel by channel, made bright enough to be seen.
 *
 * @param raster {@code factor·|a − b|} in each channel; black where they are alike
 * @param largest difference of a channel, in levels of 0 to 255
 * @param factor the largest power of two by which no channel gets brighter than 255
 */
public record MagnifiedDifference(Raster raster, int largest, int factor) {
    private static final int MOST = 128;

    public MagnifiedDifference {
        Bounds.require("largest", largest, 0, 255);
        Bounds.require("factor", factor, 1, MOST);
    }

    /**
     * @param a of the same size as {@code b}
     * @param magnified whether it is brightened at all
     */
    public static MagnifiedDifference of(Raster a, Raster b, boolean magnified) {
        int largest = 0;
        for (int i = 0; i < a.argb().length; i++)
            for (int shift = 0; shift < 24; shift += 8)
                largest = Math.max(largest, apart(a.argb()[i], b.argb()[i], shift));
        int factor =
                largest == 0 || !magnified
                        ? 1
                        : Math.min(MOST, Integer.highestOneBit(255 / largest));
        var out = new Raster(a.width(), a.height());
        for (int i = 0; i < a.argb().length; i++) {
            int argb = 0xFF000000;
            for (int shift = 0; shift < 24; shift += 8)
                argb |= factor * apart(a.argb()[i], b.argb()[i], shift) << shift;
            out.argb()[i] = argb;
        }
        return new MagnifiedDifference(out, largest, factor);
    }

    private static int apart(int a, int b, int shift) {
        return Math.abs((a >>> shift & 255) - (b >>> shift & 255));
    }
}
