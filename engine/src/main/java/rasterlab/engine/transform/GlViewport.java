package rasterlab.engine.transform;

import org.joml.Matrix4d;

/**
 * Where OpenGL shows what lies in −1..1: a rectangle of the window, in pixels from its bottom left
 * corner, y up, and a range of depths.
 *
 * <p>Source: M. Segal, K. Akeley, The OpenGL Graphics System: A Specification, version 1.5, 2003,
 * section 2.11.1.
 *
 * @param x of the rectangle's left side
 * @param y of its lower side
 * @param width at least 0
 * @param height at least 0
 * @param near depth that z = −1 gets, brought into 0..1
 * @param far depth that z = 1 gets, brought into 0..1; may be less than {@code near}
 */
public record GlViewport(int x, int y, int width, int height, double near, double far) {
    public GlViewport {
        if (width < 0 || height < 0)
            throw new IllegalArgumentException(
                    "GL_INVALID_VALUE: width and height must be at least 0, got %d×%d"
                            .formatted(width, height));
        near = clamped("near", near);
        far = clamped("far", far);
    }

    /** Viewport(x, y, width, height) with the depth range 0..1. */
    public static GlViewport viewport(int x, int y, int width, int height) {
        return new GlViewport(x, y, width, height, 0, 1);
    }

    /** The matrix from −1..1 to the window. */
    public Matrix4d matrix() {
        return GlMatrices.viewport(x, y, width, height, near, far);
    }

    private static double clamped(String name, double depth) {
        if (Double.isNaN(depth))
            throw new IllegalArgumentException(name + " must be a number from 0 to 1, got NaN");
        return Math.max(0, Math.min(1, depth));
    }
}
