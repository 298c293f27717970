package rasterlab.engine.transform;

import org.joml.Matrix4d;

/**
 * The course's projections as 4×4 matrices in the textbook's reading order for row points.
 *
 * <p>Sources: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, appendix; A.
 * V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 2 (central
 * projection) and 5 (normal and canonical volume).
 */
public final class ProjectionMatrices {
    /** Cavalier's a, the slanted axis in its full length: cos 45°. */
    public static final double CAVALIER = Math.sqrt(0.5);

    /** The a of the cabinet projection: half the length. */
    public static final double CABINET = CAVALIER / 2;

    private ProjectionMatrices() {}

    /** ORTHOX(l): onto the plane x = l. */
    public static Matrix4d orthoX(double l) {
        return new Matrix4d(
                0, 0, 0, 0, //
                0, 1, 0, 0, //
                0, 0, 1, 0, //
                l, 0, 0, 1);
    }

    /** ORTHOY(t): onto the plane y = t. */
    public static Matrix4d orthoY(double t) {
        return new Matrix4d(
                1, 0, 0, 0, //
                0, 0, 0, 0, //
                0, 0, 1, 0, //
                0, t, 0, 1);
    }

    /** ORTHOZ(n): onto the plane z = n. */
    public static Matrix4d orthoZ(double n) {
        return new Matrix4d(
                1, 0, 0, 0, //
                0, 1, 0, 0, //
                0, 0, 0, 0, //
                0, 0, n, 1);
    }

    /** TRIMETRIC: α about y, then β about x; the axes' images stand in the rows. */
    public static Matrix4d trimetric(Angle alpha, Angle beta) {
        double sa = alpha.sin();
        double ca = alpha.cos();
        double sb = beta.sin();
        double cb = beta.cos();
        return new Matrix4d(
                ca, sa * sb, -sa * cb, 0, //
                0, cb, sb, 0, //
                sa, -ca * sb, ca * cb, 0, //
                0, 0, 0, 1);
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

    /**
     * CAVALIER and CABINET: the z axis slanted by 45°.
     *
     * @param a what one unit of z moves x and y by
     */
    public static Matrix4d oblique(double a) {
        return new Matrix4d(
                1, 0, 0, 0, //
                0, 1, 0, 0, //
                -a, -a, 1, 0, //
                0, 0, 0, 1);
    }

    /** PERSPECTIVE(p, q, r): H = p·x + q·y + r·z + 1. */
    public static Matrix4d perspective(double p, double q, double r) {
        return new Matrix4d(
                1, 0, 0, p, //
                0, 1, 0, q, //
                0, 0, 1, r, //
                0, 0, 0, 1);
    }

    /** CENTRAL(k): x' = k·x / (z + k), y' = k·y / (z + k), z' = 0; the eye is at z = −k. */
    public static Matrix4d central(double k) {
        return new Matrix4d(
                k, 0, 0, 0, //
                0, k, 0, 0, //
                0, 0, 0, 1, //
                0, 0, 0, k);
    }

    /** CENTRAL_ORIGIN(k): x' = k·x / z, y' = k·y / z, z' = 0; the eye is at the origin. */
    public static Matrix4d centralFromOrigin(double k) {
        return new Matrix4d(
                k, 0, 0, 0, //
                0, k, 0, 0, //
                0, 0, 0, 1, //
                0, 0, 0, 0);
    }

    /**
     * NORMALIZE(a, x_screen, y_screen, z_max): the pyramid through a screen at z = a becomes |x| ≤
     * z, |y| ≤ z, z ≤ 1. What is at z_max on the pyramid's side, x_max = z_max·x_screen/a, becomes
     * 1.
     *
     * @param xScreen half of the screen's width
     * @param yScreen half of its height
     */
    public static Matrix4d normalize(double a, double xScreen, double yScreen, double zMax) {
        return TextbookMatrices.scale(over(a, zMax, xScreen), over(a, zMax, yScreen), 1 / zMax);
    }

    /** a/b/c, with the powers of 2 taken out, so that a/b may be no double if only a/b/c is one. */
    private static double over(double a, double b, double c) {
        int ofA = Math.getExponent(a);
        int ofB = Math.getExponent(b);
        int ofC = Math.getExponent(c);
        double near1 = Math.scalb(a, -ofA) / Math.scalb(b, -ofB) / Math.scalb(c, -ofC);
        return Math.scalb(near1, ofA - ofB - ofC);
    }

    /** CANONICAL(z_min): |x| ≤ z, |y| ≤ z, z_min ≤ z ≤ 1 becomes a box with 0 ≤ z ≤ 1. */
    public static Matrix4d canonical(double zMin) {
        double deep = 1 - zMin;
        double c = 1 / deep;
        double z = -zMin / deep;
        return new Matrix4d(
                1, 0, 0, 0, //
                0, 1, 0, 0, //
                0, 0, c, 1, //
                0, 0, z, 0);
    }
}
