package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthRange;
import rasterlab.engine.visibility.depth.FloatDepth.FloatCodes;

/**
 * {@link FloatDepth} with one addition of floats per pixel.
 *
 * <p>Each sum is rounded by up to 2⁻²⁵, so p pixels drift by up to about p·2⁻²⁵: 2⁻¹² over 8192
 * pixels where all roundings go one way.
 *
 * <p>Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, PhD
 * thesis, University of Utah, 1974.
 */
final class IncrementalFloat implements SteppedDepth {
    private final FloatDepth direct = new FloatDepth();

    @Override
    public RangeCodes over(DepthRange range) {
        FloatCodes codes = direct.over(range);
        return new SteppedCodes(
                codes, (nearness, perPixel, pixels) -> new Walk(codes, nearness, perPixel, pixels));
    }

    @Override
    public DepthWalk walk(DepthRange range, double nearness, double perPixel, int pixels) {
        return new Walk(direct.over(range), nearness, perPixel, pixels);
    }

    @Override
    public String decisionFormula() {
        return "2²⁴·(sum − (1/near − 1/z)/(1/near − 1/far)): drift in steps of floats below 1";
    }

    private static final class Walk implements DepthWalk {
        private static final double STEPS_BELOW_ONE = 1 << 24;

        private final FloatCodes codes;
        private final double nearness;
        private final double perPixel;
        private final int pixels;
        private final float step;
        private float sum;
        private int pixel;

        Walk(FloatCodes codes, double nearness, double perPixel, int pixels) {
            this.codes = codes;
            this.nearness = nearness;
            this.perPixel = perPixel;
            this.pixels = pixels;
            step = (float) codes.growth(perPixel);
            sum = (float) codes.window(nearness);
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
            return sum;
        }

        @Override
        public int code() {
            return FloatCodes.bits(sum);
        }

        @Override
        public double decision() {
            return STEPS_BELOW_ONE * (sum - codes.window(nearness + pixel * perPixel));
        }
    }
}
