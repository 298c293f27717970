package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;

/**
 * How flat the pieces of a curve must be, once rounding has had its share.
 *
 * <p>A cubic's points err by less than 2⁻⁴⁴ of the largest |coordinate| whether they come from
 * Horner's scheme, from halving or from de Casteljau's triangle up to degree 100; methods that
 * round more say how many times that. The flatness is lessened by this share, of which it must be
 * at least 16 times.
 */
final class Flatness {
    static final int MOST_SEGMENTS = 10_000_000;
    private static final double ROUNDING = 0x1p-44;
    private static final double SMALLEST = 1e-100;
    private static final double LARGEST = 1e100;

    private Flatness() {}

    /**
     * The distance in pixels left between exact curve and chord.
     *
     * @param growth how many times 2⁻⁴⁴ of the largest coordinate the method rounds
     * @throws IllegalArgumentException if the flatness is outside its range
     */
    static double left(Curve curve, double flatness, double growth) {
        if (!(flatness >= SMALLEST && flatness <= LARGEST))
            throw new IllegalArgumentException(
                    "flatness must be from " + SMALLEST + " to " + LARGEST + ", got " + flatness);
        double rounding = curve.size() * ROUNDING * growth;
        if (flatness < 16 * rounding)
            throw new IllegalArgumentException(
                    "flatness must be at least %s where coordinates reach %s, got %s"
                            .formatted(16 * rounding, curve.size(), flatness));
        return flatness - rounding;
    }
}
