package rasterlab.engine.geometry;

/**
 * Finds on which side of the line from a to b the point c lies, without error for all finite
 * doubles.
 *
 * <p>The sign of {@code det = (ax − cx)·(by − cy) − (ay − cy)·(bx − cx)}, twice the area of the
 * triangle a, b, c: 1 where it turns counter-clockwise (y up), −1 where clockwise, 0 where the
 * three lie on one line.
 *
 * <p>First in doubles. Each difference and product has a relative error of at most ε = 2⁻⁵³ and so
 * has their difference, so det is off by at most (3 + 16·ε)·ε·(|left| + |right|), to which {@link
 * #UNDERFLOW} adds more than products near zero can lose. Where |det| exceeds that, its sign is
 * right; where it does not, or an overflow made it NaN or the bound infinite, {@link
 * ExactOrientation} decides.
 *
 * <p>Source: J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates, Discrete & Computational Geometry 18, 1997, pp. 305–363.
 */
public final class Orientation {
    private static final double EPSILON = 0x1p-53;
    private static final double ROUNDING = (3 + 16 * EPSILON) * EPSILON;
    private static final double UNDERFLOW = 0x1p-1060;

    private Orientation() {}

    /**
     * The sign for three points with finite coordinates.
     *
     * @throws IllegalArgumentException if a coordinate is NaN or infinite
     */
    public static int of(double ax, double ay, double bx, double by, double cx, double cy) {
        double left = (ax - cx) * (by - cy);
        double right = (ay - cy) * (bx - cx);
        double det = left - right;
        double bound = ROUNDING * (Math.abs(left) + Math.abs(right)) + UNDERFLOW;
        if (det > bound) return 1;
        if (det < -bound) return -1;
        return ExactOrientation.of(ax, ay, bx, by, cx, cy);
    }
}
