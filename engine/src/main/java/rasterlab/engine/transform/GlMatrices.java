package rasterlab.engine.transform;

import org.joml.Matrix4d;

/**
 * The projections and the viewport of OpenGL, in the textbook's reading order for row points: the
 * transposes of what the OpenGL manual prints for columns.
 *
 * <p>Eye space is right-handed and looks along −z; what is visible has −H ≤ x, y, z ≤ H afterwards.
 *
 * <p>Source: M. Segal, K. Akeley, The OpenGL Graphics System: A Specification, version 1.5, 2003;
 * the OpenGL Utility Library's gluPerspective.
 */
public final class GlMatrices {
    private GlMatrices() {}

    /**
     * The matrix GL_ORTHO.
     *
     * @throws IllegalArgumentException where two opposite sides are equal
     */
    public static Matrix4d ortho(
            double left, double right, double bottom, double top, double near, double far) {
        requireDiffer("right", right, "left", left);
        requireDiffer("top", top, "bottom", bottom);
        requireDiffer("far", far, "near", near);
        double a = twice(1, right, left);
        double b = twice(1, top, bottom);
        double c = -twice(1, far, near);
        double x = -middle(right, left);
        double y = -middle(top, bottom);
        double z = -middle(far, near);
        return new Matrix4d(
                a, 0, 0, 0, //
                0, b, 0, 0, //
                0, 0, c, 0, //
                x, y, z, 1);
    }

    /**
     * The matrix GL_FRUSTUM.
     *
     * @param near above 0
     * @param far above 0, not {@code near}
     * @throws IllegalArgumentException where two opposite sides are equal or a distance is not
     *     above 0
     */
    public static Matrix4d frustum(
            double left, double right, double bottom, double top, double near, double far) {
        requireDiffer("right", right, "left", left);
        requireDiffer("top", top, "bottom", bottom);
        requireDistances(near, far);
        return projection(
                twice(near, right, left),
                twice(near, top, bottom),
                middle(right, left),
                middle(top, bottom),
                near,
                far);
    }

    /**
     * The matrix GL_PERSPECTIVE.
     *
     * @param fovy the whole angle of view from bottom to top, in degrees, between 0 and 180
     * @param aspect width by height, above 0
     */
    public static Matrix4d perspective(double fovy, double aspect, double near, double far) {
        if (!(fovy > 0 && fovy < 180))
            throw new IllegalArgumentException(
                    "fovy must be a number of degrees above 0 and below 180, got " + fovy);
        requirePositive("aspect", aspect);
        requireDistances(near, far);
        Angle half = Angle.ofDegrees(fovy / 2);
        double cotangent = half.cos() / half.sin();
        return projection(cotangent / aspect, cotangent, 0, 0, near, far);
    }

    private static Matrix4d projection(
            double scaleX, double scaleY, double shearX, double shearY, double near, double far) {
        double deep = far - near;
        double c = -middle(far, near);
        double d = -2 * Math.min(near, far) * (Math.max(near, far) / deep);
        return new Matrix4d(
                scaleX, 0, 0, 0, //
                0, scaleY, 0, 0, //
                shearX, shearY, c, -1, //
                0, 0, d, 0);
    }

    /**
     * VIEWPORT: from −1..1 to pixels, the origin at the bottom left, and depth n..f.
     *
     * @param width above 0
     * @param height above 0
     */
    public static Matrix4d viewport(
            double x, double y, double width, double height, double n, double f) {
        double a = width / 2;
        double b = height / 2;
        double c = Double.isFinite(f - n) ? (f - n) / 2 : f / 2 - n / 2;
        double z = Double.isFinite(n + f) ? (n + f) / 2 : n / 2 + f / 2;
        return new Matrix4d(
                a, 0, 0, 0, //
                0, b, 0, 0, //
                0, 0, c, 0, //
                x + a, y + b, z, 1);
    }

    /** 2·factor/(high − low), halved before where a double is too small for it. */
    private static double twice(double factor, double high, double low) {
        double wide = high - low;
        boolean fits = Double.isFinite(wide) && Double.isFinite(2 * factor);
        return fits ? 2 * factor / wide : factor / (high / 2 - low / 2);
    }

    /** (high + low)/(high − low), halved before where a double is too small for it. */
    private static double middle(double high, double low) {
        boolean fits = Double.isFinite(high + low) && Double.isFinite(high - low);
        return fits ? (high + low) / (high - low) : (high / 2 + low / 2) / (high / 2 - low / 2);
    }

    private static void requireDistances(double near, double far) {
        requirePositive("near", near);
        requirePositive("far", far);
        requireDiffer("far", far, "near", near);
    }

    private static void requirePositive(String name, double value) {
        if (!(value > 0 && value < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    name + " must be a finite number above 0, got " + value);
    }

    private static void requireDiffer(String name, double value, String other, double from) {
        if (value == from)
            throw new IllegalArgumentException(
                    name + " must differ from " + other + ", got both " + value);
    }
}
