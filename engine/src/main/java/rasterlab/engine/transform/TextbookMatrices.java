package rasterlab.engine.transform;

import org.joml.Matrix4d;

/**
 * The course's named 4×4 matrices, angles in radians.
 *
 * <p>Each is written in the textbook's reading order for row points {@code [x y z 1] · M}, which is
 * JOML's column order, so {@link Matrix4d#transformPosition} applies it as the textbook does. A
 * positive angle turns counter-clockwise seen from the positive end of the axis.
 *
 * <p>Source: Ponomarev, course text on computer graphics, appendix.
 */
public final class TextbookMatrices {
    private TextbookMatrices() {}

    /** ROT3DX. */
    public static Matrix4d rotationX(double angle) {
        double c = Math.cos(angle);
        double s = Math.sin(angle);
        return new Matrix4d(1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1);
    }

    /** ROT3DY. */
    public static Matrix4d rotationY(double angle) {
        double c = Math.cos(angle);
        double s = Math.sin(angle);
        return new Matrix4d(c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1);
    }

    /** SCALE3D, all axes alike. */
    public static Matrix4d scale(double factor) {
        return new Matrix4d().scaling(factor);
    }

    /** TRANSL3D: the shifts stand in the textbook's last row. */
    public static Matrix4d translation(double x, double y, double z) {
        return new Matrix4d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1);
    }

    /** One-point perspective along z: H = r·z + 1, the observer stands at z = −1/r. */
    public static Matrix4d onePointPerspective(double r) {
        return new Matrix4d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, r, 0, 0, 0, 1);
    }
}
