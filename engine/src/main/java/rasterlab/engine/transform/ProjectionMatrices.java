package rasterlab.engine.transform;

import org.joml.Matrix4d;

/**
 * The course's projections as 4×4 matrices in the textbook's reading order for row points.
 *
 * <p>Sources: Ponomarev, course text on computer graphics, appendix; Kazantsev, course text on
 * computer graphics, chapter 3 (central projection and canonical volume).
 */
public final class ProjectionMatrices {
    /** The angle of Cavalier's and Cabinet's slanted axis: cos 45°. */
    private static final double COS_45 = Math.sqrt(0.5);

    private ProjectionMatrices() {}

    /** ORTHOX(l): onto the plane x = l. */
    public static Matrix4d orthoX(double l) {
        return new Matrix4d(0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, l, 0, 0, 1);
    }

    /** ORTHOY(t): onto the plane y = t. */
    public static Matrix4d orthoY(double t) {
        return new Matrix4d(1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, t, 0, 1);
    }

    /** ORTHOZ(n): onto the plane z = n. */
    public static Matrix4d orthoZ(double n) {
        return new Matrix4d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, n, 1);
    }

    /** TRIMETRIC: α about y, then β about x; the axes' images stand in the rows. */
    public static Matrix4d trimetric(Angle alpha, Angle beta) {
        double sa = alpha.sin();
        double ca = alpha.cos();
        double sb = beta.sin();
        double cb = beta.cos();
        return new Matrix4d(
                ca, sa * sb, -sa * cb, 0, 0, cb, sb, 0, sa, -ca * sb, ca * cb, 0, 0, 0, 0, 1);
    }

    /** DIMETRIC: x and y shortened alike, z to a half: sin²α = 1/7, sin²β = 1/8. */
    public static Matrix4d dimetric() {
        return trimetric(ofSquaredSine(1, 7), ofSquaredSine(1, 8));
    }

    /** ISOMETRIC: all axes shortened alike: sin²α = 1/2, sin²β = 1/3. */
    public static Matrix4d isometric() {
        return trimetric(ofSquaredSine(1, 2), ofSquaredSine(1, 3));
    }

    private static Angle ofSquaredSine(double part, double of) {
        return new Angle(Math.sqrt(part / of), Math.sqrt((of - part) / of));
    }

    /** CAVALIER: the z axis slanted by 45° in its full length. */
    public static Matrix4d cavalier() {
        return oblique(COS_45);
    }

    /** CABINET: the z axis slanted by 45° in half its length. */
    public static Matrix4d cabinet() {
        return oblique(COS_45 / 2);
    }

    private static Matrix4d oblique(double a) {
        return new Matrix4d(1, 0, 0, 0, 0, 1, 0, 0, -a, -a, 1, 0, 0, 0, 0, 1);
    }

    /** PERSPECTIVE(p, q, r): H = p·x + q·y + r·z + 1. */
    public static Matrix4d perspective(double p, double q, double r) {
        return new Matrix4d(1, 0, 0, p, 0, 1, 0, q, 0, 0, 1, r, 0, 0, 0, 1);
    }

    /** CENTRAL(k): x' = k·x / (z + k), y' = k·y / (z + k), z' = 0; the eye is at z = −k. */
    public static Matrix4d central(double k) {
        return new Matrix4d(k, 0, 0, 0, 0, k, 0, 0, 0, 0, 0, 1, 0, 0, 0, k);
    }

    /** CENTRAL_ORIGIN(k): x' = k·x / z, y' = k·y / z, z' = 0; the eye is at the origin. */
    public static Matrix4d centralFromOrigin(double k) {
        return new Matrix4d(k, 0, 0, 0, 0, k, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0);
    }

    /** CANONICAL(z_min): |x| ≤ z, |y| ≤ z, z_min ≤ z ≤ 1 becomes a box with 0 ≤ z ≤ 1. */
    public static Matrix4d canonical(double zMin) {
        double deep = 1 - zMin;
        return new Matrix4d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 / deep, 1, 0, 0, -zMin / deep, 0);
    }
}
