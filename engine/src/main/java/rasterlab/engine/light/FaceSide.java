package rasterlab.engine.light;

/**
 * The side of a face that the picture shows, in eye space.
 *
 * @param nx x of the normal of length 1 that points out of the seen side
 * @param ny y of the normal
 * @param nz z of the normal
 * @param toEyeX x of the direction from the face's middle to the eye, of length 1
 * @param toEyeY y of the direction
 * @param toEyeZ z of the direction; negative for a face before the eye, z growing away from it
 * @param inner whether the mesh calls this side the inner one
 */
public record FaceSide(
        double nx,
        double ny,
        double nz,
        double toEyeX,
        double toEyeY,
        double toEyeZ,
        boolean inner) {
    private static final double UNIT_TOLERANCE = 1e-9;

    public FaceSide {
        requireUnit("normal", nx, ny, nz);
        requireUnit("direction to the eye", toEyeX, toEyeY, toEyeZ);
    }

    private static void requireUnit(String name, double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        if (!(Math.abs(length - 1) <= UNIT_TOLERANCE))
            throw new IllegalArgumentException(
                    "%s (%s, %s, %s) must have length 1, got %s".formatted(name, x, y, z, length));
    }
}
