package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthRange;

/**
 * Window depth (1/near − 1/z)/(1/near − 1/far) in [0, 1] as a whole number of n bits.
 *
 * <p>One step of the code is about z²·(1/near − 1/far)/2ⁿ of depth: most codes lie close to the
 * near plane.
 *
 * <p>Source: K. Akeley, J. Su, Minimum triangle separation for correct z-buffer occlusion, 2006,
 * pp. 27–30.
 */
final class FixedDepth implements DepthCoding {
    private final int bits;

    /**
     * @param bits 1 to 32
     */
    FixedDepth(int bits) {
        this.bits = bits;
    }

    @Override
    public FixedPointCodes over(DepthRange range) {
        return new FixedPointCodes(bits, range);
    }

    /** Stored number less {@code offset}, so that 32 bits compare as signed numbers. */
    static final class FixedPointCodes implements RangeCodes {
        private final double nearest;
        private final double scale;
        private final double highest;
        private final int offset;

        private FixedPointCodes(int bits, DepthRange range) {
            nearest = range.nearest();
            highest = Math.pow(2, bits) - 1;
            scale = highest / (nearest - range.farthest());
            offset = bits == Integer.SIZE ? Integer.MIN_VALUE : 0;
        }

        @Override
        public int code(double nearness) {
            return rounded(number(nearness));
        }

        @Override
        public void row(double base, double perPixel, int from, int to, int[] codes) {
            for (int i = from; i < to; i++) codes[i - from] = rounded(number(base + i * perPixel));
        }

        /** Window depth times the highest number, not rounded. */
        double number(double nearness) {
            return (nearest - nearness) * scale;
        }

        /** How much {@link #number} grows where nearness grows by {@code change}. */
        double growth(double change) {
            return -change * scale;
        }

        int rounded(double number) {
            return (int) ((long) (Math.max(0, Math.min(highest, number)) + 0.5) + offset);
        }

        @Override
        public double stored(int code) {
            return (double) code - offset;
        }

        @Override
        public double depth(int code) {
            return 1 / (nearest - stored(code) / scale);
        }
    }
}
