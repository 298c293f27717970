package rasterlab.engine.transform;

import org.joml.Matrix4d;

/**
 * Two eyes side by side that look along parallel axes at one picture plane through the origin.
 *
 * <p>In the eye space of {@code middle} the eyes stand at x = ∓e/2. A point seen by the right eye
 * lies e·(ρ/z − 1) farther to the left than seen by the left eye: behind the plane (z &gt; ρ) the
 * images are apart as the eyes are, in the plane they coincide, in front of it they cross.
 *
 * @param middle the view from between the eyes
 * @param separation e, the distance of the eyes in world units, above 0
 */
public record StereoPair(SphericalView middle, double separation) {
    public StereoPair {
        if (!(separation > 0 && separation <= SphericalView.FARTHEST))
            throw new IllegalArgumentException(
                    "separation must be above 0, up to 1000000 units, got " + separation);
    }

    /** The matrix from the world to the picture plane of the left eye: X = x/H, Y = y/H. */
    public Matrix4d left() {
        return eye(separation / 2);
    }

    /** The matrix from the world to the picture plane of the right eye. */
    public Matrix4d right() {
        return eye(-separation / 2);
    }

    /**
     * VP_L, shifted so that the eye stands at the origin, divided by z/ρ and shifted back: read
     * from right to left.
     */
    private Matrix4d eye(double toOrigin) {
        double rho = middle.rho();
        var divide =
                new Matrix4d(
                        1, 0, 0, 0, //
                        0, 1, 0, 0, //
                        0, 0, 1, 1 / rho, //
                        0, 0, 0, 0);
        return TextbookMatrices.translation(-toOrigin, 0, 0)
                .mul(divide)
                .mul(TextbookMatrices.translation(toOrigin, 0, 0))
                .mul(middle.matrix());
    }
}
