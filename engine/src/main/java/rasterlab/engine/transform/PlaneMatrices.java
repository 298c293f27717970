package rasterlab.engine.transform;

import org.joml.Matrix3d;

/**
 * The course's 3×3 matrices for row points {@code [x y 1] · M} of the plane, in the textbook's
 * reading order: the 2×2 transformation stands in the corner, the shift in the last row.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "affine
 * transformations".
 */
public final class PlaneMatrices {
    private PlaneMatrices() {}

    /** ROT2D: counter-clockwise about the origin. */
    public static Matrix3d rotation(Angle a) {
        return of(a.cos(), a.sin(), -a.sin(), a.cos());
    }

    /** The matrix SCALE2D. */
    public static Matrix3d scale(double x, double y) {
        return of(x, 0, 0, y);
    }

    /** SHEAR2D(b, c): x' = x + c·y, y' = b·x + y. */
    public static Matrix3d shear(double b, double c) {
        return of(1, b, c, 1);
    }

    /** The matrix TRANSL2D. */
    public static Matrix3d translation(double m, double n) {
        return new Matrix3d(
                1, 0, 0, //
                0, 1, 0, //
                m, n, 1);
    }

    /** The 2×2 matrix [a b; c d] in the corner. */
    public static Matrix3d of(double a, double b, double c, double d) {
        return new Matrix3d(
                a, b, 0, //
                c, d, 0, //
                0, 0, 1);
    }
}
