package rasterlab.app.opengl;

import rasterlab.engine.range.Bounds;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;

/**
 * OpenGL's picture against the software pipeline's.
 *
 * @param plain of pixels that are off by more than {@link PictureDifference#ROUNDING} levels; the
 *     others count as equal here
 * @param rounded pixels that are off by less
 * @param largest difference of any channel of any pixel, in levels 0 to 255
 */
public record Comparison(PictureDifference plain, long rounded, int largest) {
    public Comparison {
        Bounds.require("largest", largest, 0, 255);
    }

    static Comparison of(Raster openGl, Raster software) {
        int[] want = openGl.argb();
        var told = new Raster(software.width(), software.height());
        System.arraycopy(software.argb(), 0, told.argb(), 0, want.length);
        long rounded = 0;
        int largest = 0;
        for (int i = 0; i < want.length; i++) {
            int have = told.argb()[i];
            int levels = levels(have, want[i]);
            largest = Math.max(largest, levels);
            if (levels == 0 || levels > PictureDifference.ROUNDING) continue;
            told.argb()[i] = want[i];
            rounded++;
        }
        return new Comparison(PictureDifference.of(openGl, told), rounded, largest);
    }

    private static int levels(int a, int b) {
        int most = 0;
        for (int shift = 0; shift < 32; shift += 8)
            most = Math.max(most, Math.abs((a >>> shift & 255) - (b >>> shift & 255)));
        return most;
    }

    /** Pixels that are off by more than rounding, as a share of all. */
    double share() {
        return plain.share();
    }
}
