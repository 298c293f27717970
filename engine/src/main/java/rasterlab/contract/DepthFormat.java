package rasterlab.contract;

/**
 * How a depth buffer stores distances from the eye.
 *
 * <p>What is right is the order of depths: of two surfaces in one pixel the nearer one has the
 * smaller code. A format that gives both the same code lets the one that was drawn first win.
 */
@FunctionalInterface
public interface DepthFormat {
    /**
     * Stores the depths along a scan line, on which pixel i has the nearness {@code base +
     * i·perPixel}; beyond a plane a depth gets that plane's code.
     *
     * @param range the planes; the code is smallest at the near one and largest at the far one
     * @param base 1/z in pixel 0
     * @param from first pixel
     * @param to pixel after the last
     * @param codes what a depth test compares as signed numbers; filled from its beginning, {@code
     *     to − from} long or longer
     * @param depths the depth z that each code stands for, infinite at a far plane that is; filled
     *     as {@code codes} is
     * @throws IllegalArgumentException if the format cannot store depths up to that far plane
     */
    void store(
            DepthRange range,
            double base,
            double perPixel,
            int from,
            int to,
            int[] codes,
            double[] depths);
}
