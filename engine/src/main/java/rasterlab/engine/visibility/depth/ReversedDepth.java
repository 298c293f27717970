package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthRange;

/**
 * (1/z − 1/far)/(1/near − 1/far) as a float: 1 on the near plane, 0 on the far plane.
 *
 * <p>Far off, where perspective crowds depths together, the floats close to 0 are as dense: depths
 * are told apart at about 2⁻²⁴ of z wherever they are. The code is minus the float's bits.
 *
 * <p>Source: E. Lapidous, G. Jiao, Optimal depth buffer for low-cost graphics hardware, 1999.
 */
final class ReversedDepth implements DepthCoding {
    @Override
    public RangeCodes over(DepthRange range) {
        return new ReversedCodes(range);
    }

    private static final class ReversedCodes implements RangeCodes {
        private final double farthest;
        private final double scale;

        ReversedCodes(DepthRange range) {
            farthest = range.farthest();
            scale = 1 / (range.nearest() - farthest);
        }

        @Override
        public int code(double nearness) {
            float reversed = (float) ((nearness - farthest) * scale);
            return -Float.floatToRawIntBits(Math.max(0f, Math.min(1f, reversed)));
        }

        @Override
        public void row(double base, double perPixel, int from, int to, int[] codes) {
            for (int i = from; i < to; i++) codes[i - from] = code(base + i * perPixel);
        }

        @Override
        public double stored(int code) {
            return Float.intBitsToFloat(-code);
        }

        @Override
        public double depth(int code) {
            return 1 / (farthest + stored(code) / scale);
        }
    }
}
