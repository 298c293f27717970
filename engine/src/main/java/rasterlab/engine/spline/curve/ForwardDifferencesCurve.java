package rasterlab.engine.spline.curve;

/**
 * Forward differences in doubles: from point to point n additions per coordinate and no
 * multiplication.
 *
 * <p>After i steps difference k is Δᵏ at i·h; adding to each the next higher one gives those at (i
 * + 1)·h. The highest does not change. Rounding adds up from step to step: after n steps the point
 * is off by about n·2⁻⁵³ of its size.
 *
 * <p>Source: J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics: Principles and
 * Practice, 1990, chapter 11.
 */
public final class ForwardDifferencesCurve extends DifferencesCurve {
    @Override
    DifferencePoint start(double[] ofX, double[] ofY) {
        return new Doubles(ofX, ofY);
    }

    private record Doubles(double[] dx, double[] dy) implements DifferencePoint {
        @Override
        public void step() {
            for (int k = 0; k + 1 < dx.length; k++) {
                dx[k] += dx[k + 1];
                dy[k] += dy[k + 1];
            }
        }

        @Override
        public double x() {
            return dx[0];
        }

        @Override
        public double y() {
            return dy[0];
        }
    }
}
