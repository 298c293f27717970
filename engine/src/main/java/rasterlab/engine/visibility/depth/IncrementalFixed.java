package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthRange;
import rasterlab.engine.visibility.depth.FixedDepth.FixedPointCodes;

/**
 * {@link FixedDepth} with one addition per pixel, in a fixed-point number of 32 bits: what n bits
 * of depth leave is the fraction.
 *
 * <p>The step is rounded to a multiple of 2ⁿ⁻³², so p pixels drift by up to (p + 1)·2ⁿ⁻³³ codes:
 * 1/16 of a code over 8192 pixels for 16 bits, 16 codes for 24 bits.
 *
 * <p>Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, PhD
 * thesis, University of Utah, 1974.
 */
final class IncrementalFixed implements SteppedDepth {
    private final int fraction;
    private final FixedDepth direct;

    /**
     * @param bits 1 to 31
     */
    IncrementalFixed(int bits) {
        fraction = Integer.SIZE - bits;
        direct = new FixedDepth(bits);
    }

    @Override
    public RangeCodes over(DepthRange range) {
        FixedPointCodes codes = direct.over(range);
        return new SteppedCodes(
                codes, (nearness, perPixel, pixels) -> walk(codes, nearness, perPixel, pixels));
    }

    @Override
    public DepthWalk walk(DepthRange range, double nearness, double perPixel, int pixels) {
        return walk(direct.over(range), nearness, perPixel, pixels);
    }

    @Override
    public String decisionFormula() {
        return "sum − (2ⁿ − 1)·(1/near − 1/z)/(1/near − 1/far): drift in steps of the code";
    }

    private Walk walk(FixedPointCodes codes, double nearness, double perPixel, int pixels) {
        return new Walk(codes, 1L << fraction, nearness, perPixel, pixels);
    }

    /** Sum and step are multiples of 1/one. */
    private static final class Walk implements DepthWalk {
        private final FixedPointCodes codes;
        private final double one;
        private final double nearness;
        private final double perPixel;
        private final int pixels;
        private final long step;
        private long sum;
        private int pixel;

        Walk(FixedPointCodes codes, double one, double nearness, double perPixel, int pixels) {
            this.codes = codes;
            this.one = one;
            this.nearness = nearness;
            this.perPixel = perPixel;
            this.pixels = pixels;
            step = Math.round(codes.growth(perPixel) * one);
            sum = Math.round(codes.number(nearness) * one);
        }

        @Override
        public boolean advance() {
            if (pixel == pixels - 1) return false;
            pixel++;
            sum += step;
            return true;
        }

        @Override
        public int pixel() {
            return pixel;
        }

        @Override
        public double sum() {
            return sum / one;
        }

        @Override
        public int code() {
            return codes.rounded(sum / one);
        }

        @Override
        public double decision() {
            return sum() - codes.number(nearness + pixel * perPixel);
        }
    }
}
