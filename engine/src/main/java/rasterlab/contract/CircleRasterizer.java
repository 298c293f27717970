package rasterlab.contract;

/**
 * Draws a circle about a pixel centre.
 *
 * <p>With (u, v) counted from the centre, the circle u² + v² = r² lights, in the octant 0 ≤ u ≤ v,
 * in each column u the row v nearest to √(r² − u²), and the seven mirror images of these pixels. No
 * column has a tie: √(r² − u²) is never midway between two whole numbers. A circle of radius 0 is
 * one pixel.
 */
@FunctionalInterface
public interface CircleRasterizer {
    /**
     * Sends the pixels of the circle, in any order.
     *
     * @param centerX column of the centre; centreX ± radius has to be an int
     * @param centerY row of the centre; centreY ± radius has to be an int
     * @param radius in pixels, at least 0
     * @param out receives each pixel once
     * @throws IllegalArgumentException if the method cannot draw this circle; the message names the
     *     value and the range
     */
    void draw(int centerX, int centerY, int radius, Pixels out);
}
