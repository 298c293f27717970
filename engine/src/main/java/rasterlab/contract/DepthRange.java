package rasterlab.contract;

/**
 * The planes between which a perspective view shows anything, as distances z from the eye along the
 * line of sight. Nearness is 1/z, which is linear along a scan line where z is not.
 *
 * @param near 10⁻¹⁰⁰ to 10¹⁰⁰
 * @param far at least 1.000001 times near, up to 10¹⁰⁰; or infinite, for no far plane
 */
public record DepthRange(double near, double far) {
    private static final double LARGEST = 1e100;
    private static final double LEAST_RATIO = 1.000001;

    public DepthRange {
        if (!(near >= 1 / LARGEST && near <= LARGEST))
            throw new IllegalArgumentException("near must be from 1E-100 to 1E100, got " + near);
        if (!(far >= LEAST_RATIO * near && (far <= LARGEST || far == Double.POSITIVE_INFINITY)))
            throw new IllegalArgumentException(
                    "far must be at least %s·near and at most 1E100, or infinite, got %s with near %s"
                            .formatted(LEAST_RATIO, far, near));
    }

    /** 1/near, the greatest nearness. */
    public double nearest() {
        return 1 / near;
    }

    /** 1/far, the least nearness; 0 where there is no far plane. */
    public double farthest() {
        return 1 / far;
    }
}
