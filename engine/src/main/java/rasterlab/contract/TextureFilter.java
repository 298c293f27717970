package rasterlab.contract;

/**
 * Finds the colour of pixels that show a picture made larger or smaller.
 *
 * <p>The picture repeats itself without end. What is right is its mean over the pixel's footprint:
 * the parallelogram about (s, t) that has the pixel's steps to the right and down as its sides. One
 * of less than 10⁻¹² of a texel's area counts as a point: it shows the texel that (s, t) lies in,
 * ⌊s·width⌋ and ⌊t·height⌋, a border belonging to the texel to the right and above.
 */
@FunctionalInterface
public interface TextureFilter {
    /** Colours of one picture. */
    @FunctionalInterface
    interface Lookup {
        /**
         * The colour of a pixel.
         *
         * @param s of its centre, 0 to 1 across the picture
         * @param t of its centre, 0 to 1 up the picture
         * @param dsdx how s changes to the next pixel on the right
         * @param dtdx how t does
         * @param dsdy how s changes to the next pixel below
         * @param dtdy how t does
         * @return 0xAARRGGBB
         * @throws IllegalArgumentException if the method cannot filter that footprint
         */
        int color(double s, double t, double dsdx, double dtdx, double dsdy, double dtdy);
    }

    /**
     * Makes ready what does not depend on the pixel.
     *
     * @param width 1 to 8192
     * @param height 1 to 8192
     * @param argb 0xAARRGGBB row by row, the bottom row first
     */
    Lookup prepare(int width, int height, int[] argb);
}
