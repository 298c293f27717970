package rasterlab.contract;

/**
 * Draws a straight segment between two pixel centres.
 *
 * <p>With n = max(|x1 − x0|, |y1 − y0|) the segment has n + 1 pixels: one for each whole step along
 * its longer axis, each the nearest to the exact line. Where the exact line passes midway between
 * two pixels, the one with the smaller coordinate on the shorter axis is lit, so that both
 * directions light the same pixels. Both ends are lit, pixels are sent from (x0, y0) to (x1, y1),
 * and a single point is one pixel.
 */
@FunctionalInterface
public interface LineRasterizer {
    /**
     * Sends the pixels of the segment from (x0, y0) to (x1, y1).
     *
     * @param out receives each pixel once
     * @throws IllegalArgumentException if the method cannot draw this segment; the message names
     *     the value and the range
     */
    void draw(int x0, int y0, int x1, int y1, Pixels out);
}
