package rasterlab.engine.light;

/**
 * One Lambert intensity per face: {@code I = a + (1 − a)·max(0, n·l)}, a being the ambient share.
 *
 * <p>n points out of the seen side and l to the light, both of length 1 up to rounding, which the
 * cut of n·l to [0, 1] keeps out, so I stays within [a, 1]; a light behind the seen side adds
 * nothing.
 *
 * <p>Source: J. H. Lambert, Photometria, 1760, for n·l; the mix with an ambient share is ours.
 */
public final class FlatShading implements Shading {
    /** The ambient share unless another is given. */
    public static final double AMBIENT = 0.2;

    private final double ambient;
    private final boolean atEye;
    private final double lightX;
    private final double lightY;
    private final double lightZ;

    private FlatShading(double ambient, boolean atEye, double x, double y, double z) {
        if (!(ambient >= 0 && ambient <= 1))
            throw new IllegalArgumentException("ambient must be from 0 to 1, got " + ambient);
        this.ambient = ambient;
        this.atEye = atEye;
        lightX = x;
        lightY = y;
        lightZ = z;
    }

    /** The light is at the eye. */
    public static FlatShading lightAtEye(double ambient) {
        return new FlatShading(ambient, true, 0, 0, 0);
    }

    /**
     * The light is infinitely far in the direction (x, y, z) of eye space, of any length above 0.
     */
    public static FlatShading lightFrom(double ambient, double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        if (!(length > 0 && length < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "direction to the light must be finite and not zero, got (%s, %s, %s)"
                            .formatted(x, y, z));
        return new FlatShading(ambient, false, x / length, y / length, z / length);
    }

    @Override
    public double intensity(FaceSide side) {
        double x = atEye ? side.toEyeX() : lightX;
        double y = atEye ? side.toEyeY() : lightY;
        double z = atEye ? side.toEyeZ() : lightZ;
        double cosine = side.nx() * x + side.ny() * y + side.nz() * z;
        return ambient + (1 - ambient) * Math.max(0, Math.min(1, cosine));
    }
}
