package rasterlab.engine.visibility;

/**
 * How far planes and depths may differ that are meant to be one: what rounding makes of a plane
 * that is computed from two faces in it.
 *
 * <p>A plane is computed from corners in some ten roundings of 2⁻⁵³, and 2⁻⁴⁴ is 512 of them. That
 * is no proof: of a face that is small beside its distance from the origin the plane is less sure.
 */
public final class OnePlane {
    private static final double SHARE = 0x1p-44;

    private OnePlane() {}

    /** The most by which numbers of such a size may differ. */
    public static double room(double size) {
        return SHARE * Math.abs(size);
    }
}
