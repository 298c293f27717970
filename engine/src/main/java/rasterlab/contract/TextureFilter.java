package rasterlab.contract;

/**
 * Finds the colours of pixels that show a picture made larger or smaller.
 *
 * <p>The picture repeats itself without end. What is right is its mean over the pixel's footprint:
 * the parallelogram about (s, t) that has the pixel's steps to the right and down as its sides. One
 * of less than 10⁻¹² of a texel's area counts as a point: it shows the texel that (s, t) lies in,
 * ⌊s·width⌋ and ⌊t·height⌋, a border belonging to the texel to the right and above. Each channel,
 * alpha too, is a whole level from 0 to 255 at most half a level and 10⁻⁶ from its mean. An
 * exercise may ask for a quicker value in place of that mean, such as the four nearest texels
 * mixed; it says which.
 */
@FunctionalInterface
public interface TextureFilter {
    /**
     * The colours of pixels.
     *
     * @param width of the picture, 1 to 8192
     * @param height of the picture, 1 to 8192
     * @param argb its texels 0xAARRGGBB row by row, the bottom row first
     * @param footprints six numbers of each pixel, one pixel after the other: s of its centre, 0 to
     *     1 across the picture, t of its centre, 0 to 1 up the picture, how s and t change to the
     *     next pixel on the right, and how s and t change to the next pixel below
     * @return 0xAARRGGBB of each pixel
     * @throws IllegalArgumentException if a footprint is turned, that is, its dt/dx or ds/dy is not
     *     0, and the method filters upright ones alone; nothing else may be refused
     */
    int[] colors(int width, int height, int[] argb, double[] footprints);
}
