package rasterlab.engine.transform;

import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * The course's named 4×4 matrices of motion and scale.
 *
 * <p>Each is written in the textbook's reading order for row points {@code [x y z 1] · M}, which is
 * JOML's column order, so {@link Matrix4d#transformPosition} applies it as the textbook does. A
 * positive angle turns counter-clockwise seen from the positive end of the axis.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, appendix,
 * whose scales and shift are printed with zeros on the diagonal where ones belong.
 */
public final class TextbookMatrices {
    /**
     * Coordinates beyond it may leave the doubles in a sum of products, of which there are three.
     */
    private static final double LARGEST_PRODUCT = 0x1p1020;

    private TextbookMatrices() {}

    /** ROT3DX, the angle in radians. */
    public static Matrix4d rotationX(double angle) {
        return rotationX(Angle.ofRadians(angle));
    }

    /** The matrix ROT3DX. */
    public static Matrix4d rotationX(Angle a) {
        return new Matrix4d(
                1, 0, 0, 0, //
                0, a.cos(), a.sin(), 0, //
                0, -a.sin(), a.cos(), 0, //
                0, 0, 0, 1);
    }

    /** ROT3DY, the angle in radians. */
    public static Matrix4d rotationY(double angle) {
        return rotationY(Angle.ofRadians(angle));
    }

    /** The matrix ROT3DY. */
    public static Matrix4d rotationY(Angle a) {
        return new Matrix4d(
                a.cos(), 0, -a.sin(), 0, //
                0, 1, 0, 0, //
                a.sin(), 0, a.cos(), 0, //
                0, 0, 0, 1);
    }

    /** The matrix ROT3DZ. */
    public static Matrix4d rotationZ(Angle a) {
        return new Matrix4d(
                a.cos(), a.sin(), 0, 0, //
                -a.sin(), a.cos(), 0, 0, //
                0, 0, 1, 0, //
                0, 0, 0, 1);
    }

    /**
     * ROTAXIS: about the line through A along the unit vector k, by Rodrigues' formula. Row i is
     * the image of axis i, {@code e·cos + (k × e)·sin + k·(k·e)·(1 − cos)}; the last row is {@code
     * A − A·R}.
     *
     * @param k of length 1
     */
    public static Matrix4d rotationAbout(Vector3d a, Vector3d k, Angle by) {
        double s = by.sin();
        double c = by.cos();
        double xx = k.x * k.x * (1 - c);
        double yy = k.y * k.y * (1 - c);
        double zz = k.z * k.z * (1 - c);
        double xy = k.x * k.y * (1 - c);
        double yz = k.y * k.z * (1 - c);
        double zx = k.z * k.x * (1 - c);
        double x = k.x * s;
        double y = k.y * s;
        double z = k.z * s;
        var turn =
                new Matrix4d(
                        c + xx, xy + z, zx - y, 0, //
                        xy - z, c + yy, yz + x, 0, //
                        zx + y, yz - x, c + zz, 0, //
                        0, 0, 0, 1);
        // The vectors are scaled down where a sum would overflow, though the difference does not.
        double part = largest(a) > LARGEST_PRODUCT ? 0x1p-4 : 1;
        Vector3d at = new Vector3d(a).mul(part);
        Vector3d moved = turn.transformPosition(new Vector3d(at)).negate().add(at);
        return turn.setTranslation(moved.mul(1 / part));
    }

    private static double largest(Vector3d v) {
        return Math.max(Math.abs(v.x), Math.max(Math.abs(v.y), Math.abs(v.z)));
    }

    /** SCALE3DX(a), SCALE3DY(e), SCALE3DZ(j) in one: the cells a, e, j of the general matrix. */
    public static Matrix4d scale(double a, double e, double j) {
        return new Matrix4d(
                a, 0, 0, 0, //
                0, e, 0, 0, //
                0, 0, j, 0, //
                0, 0, 0, 1);
    }

    /** SCALE3D(s): H = s, so that all coordinates become 1/s as large. */
    public static Matrix4d uniformScale(double s) {
        return new Matrix4d(
                1, 0, 0, 0, //
                0, 1, 0, 0, //
                0, 0, 1, 0, //
                0, 0, 0, s);
    }

    /** TRANSL3D: the shifts stand in the textbook's last row. */
    public static Matrix4d translation(double x, double y, double z) {
        return new Matrix4d(
                1, 0, 0, 0, //
                0, 1, 0, 0, //
                0, 0, 1, 0, //
                x, y, z, 1);
    }
}
