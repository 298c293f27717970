package rasterlab.engine.texture;

/**
 * Which level of a texture a pixel needs: λ = log₂ ρ, ρ being how many texels of level 0 one step
 * on the screen crosses, to the right or down, whichever is more.
 *
 * <p>Source: M. Segal, K. Akeley, The OpenGL Graphics System: A Specification, version 2.1, 2006,
 * section 3.8.8.
 */
public final class DetailLevel {
    private DetailLevel() {}

    /**
     * ρ² from the screen derivatives of s and t.
     *
     * @param width of level 0 in texels
     * @param height of level 0 in texels
     */
    public static double squaredStep(
            double dsdx, double dtdx, double dsdy, double dtdy, int width, int height) {
        double ux = dsdx * width;
        double vx = dtdx * height;
        double uy = dsdy * width;
        double vy = dtdy * height;
        return Math.max(ux * ux + vx * vx, uy * uy + vy * vy);
    }

    /** Computes ρ² of many pixels, in place of their ∂s/∂x. */
    public static void squareSteps(
            int count,
            float[] dsdx,
            float[] dtdx,
            float[] dsdy,
            float[] dtdy,
            int width,
            int height) {
        for (int i = 0; i < count; i++) {
            float ux = dsdx[i] * width;
            float vx = dtdx[i] * height;
            float uy = dsdy[i] * width;
            float vy = dtdy[i] * height;
            float right = ux * ux + vx * vx;
            float down = uy * uy + vy * vy;
            // The larger of them, without a branch: such a loop becomes vector instructions.
            dsdx[i] = 0.5f * (right + down + Math.abs(right - down));
        }
    }

    /** λ = ½·log₂ ρ²; −∞ where nothing moves. */
    public static double of(double squaredStep) {
        return 0.5 * Math.log(squaredStep) / Math.log(2);
    }

    /**
     * λ within 0.005, for every pixel of a picture: the exponent of ρ², and a parabola through the
     * logarithm of its fraction.
     *
     * @param squaredStep a normal double above 0; smaller ones give a λ below −500
     */
    public static double quick(double squaredStep) {
        int exponent = Math.getExponent(squaredStep);
        double fraction = squaredStep * Math.scalb(1.0, -exponent) - 1;
        return 0.5 * (exponent + fraction * (1.3465 - 0.3465 * fraction));
    }
}
