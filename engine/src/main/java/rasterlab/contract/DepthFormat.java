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
     * Makes ready what depends on the two planes only.
     *
     * @throws IllegalArgumentException if the format cannot store depths up to that far plane
     */
    Codes over(DepthRange range);

    /** The codes of one range, from the smallest at the near plane to the largest at the far. */
    interface Codes {
        /**
         * The code of a single depth.
         *
         * @param nearness 1/z; beyond a plane it gets that plane's code
         * @return what a depth test compares as signed numbers
         */
        int code(double nearness);

        /**
         * The codes along a scan line, on which pixel i has the nearness {@code base + i·perPixel}.
         *
         * @param from first pixel
         * @param to pixel after the last
         * @param codes filled from its beginning, {@code to − from} long or longer
         */
        void row(double base, double perPixel, int from, int to, int[] codes);

        /** What the buffer holds for a code: a whole number or a float. */
        double stored(int code);

        /** The depth z that a code stands for; infinite at a far plane that is. */
        double depth(int code);
    }
}
