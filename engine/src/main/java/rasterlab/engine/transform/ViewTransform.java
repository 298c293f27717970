package rasterlab.engine.transform;

import org.joml.Matrix4d;

/**
 * World → eye space: x right, y up, z forward. The eye is at its origin in perspective; in parallel
 * projection all lines of sight run along its z.
 *
 * <p>An oblique projection slants eye space itself, so lengths and angles are the world's only
 * where {@link Projection} is not oblique: light is computed in the world.
 */
public final class ViewTransform {
    private final Projection projection;
    private final double distance;
    private final double[] toEye;
    private final double[] normalToEye;
    private final double[] toWorld;

    /**
     * @param camera drawn upright
     */
    public ViewTransform(SphericalView camera, Projection projection) {
        this(camera, projection, 0);
    }

    /**
     * The transform for an eye that stands beside the camera's, with the same line of sight.
     *
     * @param toTheRight how far, in world units
     */
    public ViewTransform(SphericalView camera, Projection projection, double toTheRight) {
        this.projection = projection;
        distance = camera.rho();
        Matrix4d matrix =
                new Matrix4d()
                        .translation(-toTheRight, 0, 0)
                        .mul(projection.worldToView(camera.upright()));
        toEye = matrix.get(new double[16]);
        normalToEye =
                projection.oblique() ? matrix.normal(new Matrix4d()).get(new double[16]) : toEye;
        toWorld = matrix.invertAffine(new Matrix4d()).get(new double[16]);
    }

    public Projection projection() {
        return projection;
    }

    /** Whether lines of sight meet in the eye. */
    public boolean central() {
        return projection == Projection.PERSPECTIVE;
    }

    /** ρ: the world's origin is at z = ρ, and so is the picture plane in perspective. */
    public double distance() {
        return distance;
    }

    /** One coordinate of a world point in eye space: axis 0 is x, 1 is y, 2 is z. */
    public double toEye(int axis, double x, double y, double z) {
        return toEye[axis] * x + toEye[4 + axis] * y + toEye[8 + axis] * z + toEye[12 + axis];
    }

    /**
     * An entry of the matrix from world to eye, for points as columns.
     *
     * @param column 0 to 2 for x, y, z; 3 for what is added
     */
    public double entry(int axis, int column) {
        return toEye[4 * column + axis];
    }

    /** One coordinate of a plane's normal in eye space, not of length 1 in an oblique one. */
    public double normalToEye(int axis, double x, double y, double z) {
        return normalToEye[axis] * x + normalToEye[4 + axis] * y + normalToEye[8 + axis] * z;
    }

    /** One coordinate of an eye-space point in the world. */
    public double toWorld(int axis, double x, double y, double z) {
        return toWorld[axis] * x
                + toWorld[4 + axis] * y
                + toWorld[8 + axis] * z
                + toWorld[12 + axis];
    }

    /**
     * One coordinate of the direction in the world, of length 1, that the middle of the picture is
     * looked at along.
     */
    public double sight(int axis) {
        double x = toWorld[8];
        double y = toWorld[9];
        double z = toWorld[10];
        return toWorld[8 + axis] / Math.sqrt(x * x + y * y + z * z);
    }
}
