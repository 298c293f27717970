package rasterlab.engine.spline.curve;

/**
 * Forward differences in floats, as they were long taught for speed: after n steps the point is off
 * by about n·2⁻²⁴ of its size, which a long curve shows.
 *
 * <p>Source: J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics: Principles and
 * Practice, 1990, chapter 11.
 */
public final class ForwardDifferencesFloatCurve extends DifferencesCurve {
    @Override
    DifferencePoint start(double[] ofX, double[] ofY) {
        return new Floats(floats(ofX), floats(ofY));
    }

    private static float[] floats(double[] doubles) {
        var floats = new float[doubles.length];
        for (int i = 0; i < floats.length; i++) {
            floats[i] = (float) doubles[i];
            if (Float.isInfinite(floats[i]))
                throw new IllegalArgumentException(
                        "points: differences must be from %s to %s, got %s"
                                .formatted(-Float.MAX_VALUE, Float.MAX_VALUE, doubles[i]));
        }
        return floats;
    }

    private record Floats(float[] dx, float[] dy) implements DifferencePoint {
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
