package rasterlab.engine.clip.segment;

/**
 * The rounding of coordinates that are computed in doubles.
 *
 * <p>With u = 2⁻⁵³, a difference of two doubles and a quotient each err by a share u at most, so a
 * t computed as (side − x0)/(x1 − x0) errs by a share of 3·u, and p0 + t·(p1 − p0) by 5·u·|p1 − p0|
 * and its own rounding. With |x1 − x0|, |y1 − y0| ≤ 512·size, size being the window's width and
 * height together, that is 5.7·10⁻¹³ of the larger one.
 */
final class RoundingBound {
    private static final double LONGEST = 512;
    private static final double SMALLEST = 0x1p-300;
    private static final double LARGEST = 0x1p300;

    private RoundingBound() {}

    /**
     * Whether the bound holds for a window and a segment that extends by dx and dy: not where it is
     * too long for the window, nor where the window is so small or large that products might
     * underflow or overflow, nor for anything that is not finite, nor for swapped sides.
     */
    static boolean holds(double width, double height, double dx, double dy) {
        double size = width + height;
        // Written so that NaN makes it false.
        return Math.abs(dx) <= LONGEST * size
                && Math.abs(dy) <= LONGEST * size
                && size >= SMALLEST
                && size <= LARGEST
                && width >= 0
                && height >= 0;
    }

    /**
     * Whether the rounding of a computed coordinate may hide on which side of one of two lines it
     * is; more than the bound above.
     *
     * @param size of the window
     */
    static boolean hides(double size, double computed, double low, double high) {
        double most = 0x1p-40 * size + 0x1p-51 * (Math.abs(low) + Math.abs(high));
        return Math.abs(computed - low) <= most | Math.abs(computed - high) <= most;
    }
}
