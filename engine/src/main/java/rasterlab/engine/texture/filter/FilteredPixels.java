package rasterlab.engine.texture.filter;

import java.util.ArrayList;
import java.util.List;

/**
 * Pixels that show a picture.
 *
 * @param width of the picture in texels
 * @param height of the picture in texels
 * @param argb its texels row by row, the bottom row first
 * @param footprints s, t, ds/dx, dt/dx, ds/dy, dt/dy of each pixel, one after the other
 */
public record FilteredPixels(int width, int height, int[] argb, double[] footprints) {
    /** Numbers of each pixel. */
    static final int NUMBERS = 6;

    /** The most texels a side of a footprint may cross. */
    private static final double LONGEST = 4096;

    public FilteredPixels {
        if (footprints.length % NUMBERS != 0)
            throw new IllegalArgumentException(
                    "pixels must have 6 numbers each, got " + footprints.length + " in all");
        for (int i = 0; i < footprints.length; i++) {
            double texels = footprints[i] * (i % 2 == 0 ? width : height);
            if (!(Math.abs(texels) <= LONGEST))
                throw new IllegalArgumentException(
                        "pixels[%d][%d] must stay within 4096 texels, got %s"
                                .formatted(i / NUMBERS, i % NUMBERS, footprints[i]));
        }
        argb = argb.clone();
        footprints = footprints.clone();
    }

    /** The result for one pixel. */
    @FunctionalInterface
    interface FootprintFunction<T> {
        T of(double s, double t, double dsdx, double dtdx, double dsdy, double dtdy);
    }

    /** The result for each, in their order. */
    <T> List<T> each(FootprintFunction<T> make) {
        var made = new ArrayList<T>();
        for (int at = 0; at < footprints.length; at += NUMBERS)
            made.add(
                    make.of(
                            footprints[at],
                            footprints[at + 1],
                            footprints[at + 2],
                            footprints[at + 3],
                            footprints[at + 4],
                            footprints[at + 5]));
        return made;
    }

    public int count() {
        return footprints.length / NUMBERS;
    }
}
