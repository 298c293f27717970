package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthRange;

/**
 * Window depth (1/near − 1/z)/(1/near − 1/far) in [0, 1] as a float.
 *
 * <p>Most depths lie close to 1, where floats are 2⁻²⁴ apart: no finer than 24 bits. The many
 * floats close to 0 are spent next to the near plane. The bits of floats from 0 up are in their
 * order.
 *
 * <p>Source: K. Akeley, J. Su, Minimum triangle separation for correct z-buffer occlusion, 2006,
 * pp. 27–30.
 */
final class FloatDepth implements DepthCoding {
    @Override
    public FloatCodes over(DepthRange range) {
        return new FloatCodes(range);
    }

    static final class FloatCodes implements RangeCodes {
        private final double nearest;
        private final double scale;

        private FloatCodes(DepthRange range) {
            nearest = range.nearest();
            scale = 1 / (nearest - range.farthest());
        }

        @Override
        public int code(double nearness) {
            return bits((float) window(nearness));
        }

        @Override
        public void row(double base, double perPixel, int from, int to, int[] codes) {
            for (int i = from; i < to; i++)
                codes[i - from] = bits((float) window(base + i * perPixel));
        }

        double window(double nearness) {
            return (nearest - nearness) * scale;
        }

        /** How much {@link #window} grows where nearness grows by {@code change}. */
        double growth(double change) {
            return -change * scale;
        }

        static int bits(float window) {
            return Float.floatToRawIntBits(Math.max(0f, Math.min(1f, window)));
        }

        @Override
        public double stored(int code) {
            return Float.intBitsToFloat(code);
        }

        @Override
        public double depth(int code) {
            return 1 / (nearest - stored(code) / scale);
        }
    }
}
