package rasterlab.engine.sight;

/**
 * The fewest bits of a depth buffer that tell two depths apart.
 *
 * <p>A code of n bits is a step of 2⁻ⁿ in {@code (1/near − 1/z)/(1/near − 1/far)}; at depth z it
 * stands for {@code Δz = z²·(1/near − 1/far)/2ⁿ}. Two depths have different codes where they are
 * more than one step apart.
 *
 * <p>Source: K. Akeley, J. Su, Minimum triangle separation for correct z-buffer occlusion, 2006,
 * pp. 27–30.
 */
public final class DepthBits {
    private DepthBits() {}

    /** World units of one code at depth z. */
    public static double step(int bits, double z, double near, double far) {
        return z * z * (1 / near - 1 / far) / Math.scalb(1.0, bits);
    }

    /**
     * @param z the farthest depth at which anything must be told apart
     * @param separation the smallest distance along the line of sight that must be, above 0
     * @return 1 or more
     */
    public static int fewest(double z, double near, double far, double separation) {
        if (!(separation > 0))
            throw new IllegalArgumentException("separation must be above 0, got " + separation);
        int bits = 1;
        while (bits < 64 && !(step(bits, z, near, far) < separation)) bits++;
        return bits;
    }
}
