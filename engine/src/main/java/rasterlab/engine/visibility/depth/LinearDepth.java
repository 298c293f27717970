package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthRange;

/**
 * (z − near)/(far − near) as a whole number of n bits: a w-buffer.
 *
 * <p>One step of the code is (far − near)/(2ⁿ − 1) of depth everywhere. z is not linear along a
 * scan line, so each pixel costs a division.
 *
 * <p>Source: E. Lapidous, G. Jiao, Optimal depth buffer for low-cost graphics hardware, 1999.
 */
final class LinearDepth implements DepthCoding {
    private final int bits;

    /**
     * @param bits 1 to 31
     */
    LinearDepth(int bits) {
        this.bits = bits;
    }

    @Override
    public RangeCodes over(DepthRange range) {
        if (range.far() == Double.POSITIVE_INFINITY)
            throw new IllegalArgumentException(
                    "far must be finite for equal steps of depth, got " + range.far());
        return new LinearCodes(bits, range);
    }

    private static final class LinearCodes implements RangeCodes {
        private final double near;
        private final double farthest;
        private final double scale;
        private final double highest;

        LinearCodes(int bits, DepthRange range) {
            near = range.near();
            farthest = range.farthest();
            highest = Math.pow(2, bits) - 1;
            scale = highest / (range.far() - near);
        }

        @Override
        public int code(double nearness) {
            double number = (1 / Math.max(farthest, nearness) - near) * scale;
            return (int) (Math.max(0, Math.min(highest, number)) + 0.5);
        }

        @Override
        public void row(double base, double perPixel, int from, int to, int[] codes) {
            for (int i = from; i < to; i++) codes[i - from] = code(base + i * perPixel);
        }

        @Override
        public double stored(int code) {
            return code;
        }

        @Override
        public double depth(int code) {
            return near + code / scale;
        }
    }
}
