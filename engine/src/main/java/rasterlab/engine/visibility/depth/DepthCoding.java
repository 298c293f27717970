package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthFormat;
import rasterlab.contract.DepthRange;

/** A format that tells the code of any depth, also of one that is on no scan line. */
@FunctionalInterface
public interface DepthCoding extends DepthFormat {
    /**
     * Makes ready what depends on the two planes only.
     *
     * @throws IllegalArgumentException if the format cannot store depths up to that far plane
     */
    RangeCodes over(DepthRange range);

    @Override
    default void store(
            DepthRange range,
            double base,
            double perPixel,
            int from,
            int to,
            int[] codes,
            double[] depths) {
        RangeCodes coder = over(range);
        coder.row(base, perPixel, from, to, codes);
        for (int i = 0; i < to - from; i++) depths[i] = coder.depth(codes[i]);
    }

    /** The codes of one range, from the smallest at the near plane to the largest at the far. */
    interface RangeCodes {
        /**
         * The code of a single depth.
         *
         * @param nearness 1/z; beyond a plane it gets that plane's code
         * @return what a depth test compares as signed numbers
         */
        int code(double nearness);

        /**
         * Computes the codes along a scan line, on which pixel i has the nearness {@code base +
         * i·perPixel}.
         *
         * @param from first pixel
         * @param to pixel after the last
         * @param codes filled from its beginning, {@code to − from} long or longer
         */
        void row(double base, double perPixel, int from, int to, int[] codes);

        /** Returns the number that the buffer holds for a code: a whole one or a float. */
        double stored(int code);

        /** The depth z that a code stands for; infinite at a far plane that is. */
        double depth(int code);
    }
}
