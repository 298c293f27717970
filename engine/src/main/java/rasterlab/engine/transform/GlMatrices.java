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
     * GL_ORTHO.
     *
     * @throws IllegalArgumentException where two opposite sides are equal
     */
    public static Matrix4d ortho(
            double left, double right, double bottom, double top, double near, double far) {
        requireDiffer("right", right, "left", left);
        requireDiffer("top", top, "bottom", bottom);
        requireDiffer("far", far, "near", near);
        double wide = right - left;
        double high = top - bottom;
        double deep = far - near;
        return new Matrix4d(
                2 / wide,
                0,
                0,
                0,
                0,
                2 / high,
                0,
                0,
                0,
                0,
                -2 / deep,
                0,
                -(right + left) / wide,
                -(top + bottom) / high,
                -(far + near) / deep,
                1);
    }

    /**
     * GL_FRUSTUM.
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
        double wide = right - left;
        double high = top - bottom;
        return projection(
                2 * near / wide,
                2 * near / high,
                (right + left) / wide,
                (top + bottom) / high,
                near,
                far);
    }

    /**
     * GL_PERSPECTIVE.
     *
     * @param fovy the whole angle of view from bottom to top, in degrees, between 0 and 180
     * @param aspect width by height, above 0
     */
    public static Matrix4d perspective(double fovy, double aspect, double near, double far) {
        if (!(fovy > 0 && fovy < 180))
            throw new IllegalArgumentException(
                    "fovy must be above 0 and below 180 degrees, got " + fovy);
        if (!(aspect > 0))
            throw new IllegalArgumentException("aspect must be above 0, got " + aspect);
        requireDistances(near, far);
        Angle half = Angle.ofDegrees(fovy / 2);
        double cotangent = half.cos() / half.sin();
        return projection(cotangent / aspect, cotangent, 0, 0, near, far);
    }

    private static Matrix4d projection(
            double scaleX, double scaleY, double shearX, double shearY, double near, double far) {
        double deep = far - near;
        return new Matrix4d(
                scaleX,
                0,
                0,
                0,
                0,
                scaleY,
                0,
                0,
                shearX,
                shearY,
                -(far + near) / deep,
                -1,
                0,
                0,
                -2 * Math.min(near, far) * (Math.max(near, far) / deep),
                0);
    }

    /**
     * VIEWPORT: from −1..1 to pixels, the origin at the bottom left, and depth n..f.
     *
     * @param width above 0
     * @param height above 0
     */
    public static Matrix4d viewport(
            double x, double y, double width, double height, double n, double f) {
        return new Matrix4d(
                width / 2,
                0,
                0,
                0,
                0,
                height / 2,
                0,
                0,
                0,
                0,
                (f - n) / 2,
                0,
                x + width / 2,
                y + height / 2,
                (n + f) / 2,
                1);
    }

    private static void requireDistances(double near, double far) {
        if (!(near > 0)) throw new IllegalArgumentException("near must be above 0, got " + near);
        if (!(far > 0)) throw new IllegalArgumentException("far must be above 0, got " + far);
        requireDiffer("far", far, "near", near);
    }

    private static void requireDiffer(String name, double value, String other, double from) {
        if (value == from)
            throw new IllegalArgumentException(
                    name + " must differ from " + other + ", got both " + value);
    }
}
