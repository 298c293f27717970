package rasterlab.app.clip.scene;

import org.joml.Matrix4d;
import rasterlab.engine.transform.ProjectionMatrices;

/**
 * The screen that the eye looks through, in eye units; all above 0.
 *
 * @param distance of the screen from the eye, a
 * @param halfWidth x_s
 * @param halfHeight y_s
 * @param farthest z_max, distance of the farthest plane
 */
public record Screen(double distance, double halfWidth, double halfHeight, double farthest) {
    static final Screen FIRST = new Screen(2, 1.2, 0.8, 5);

    public Screen {
        require("distance", distance);
        require("halfWidth", halfWidth);
        require("halfHeight", halfHeight);
        require("farthest", farthest);
    }

    private static void require(String name, double value) {
        if (!(value >= 1e-3 && value <= 1e3))
            throw new IllegalArgumentException(name + " must be in [0.001, 1000], got " + value);
    }

    /** NORMALIZE: from eye space to the normalised one. */
    public Matrix4d normalize() {
        return ProjectionMatrices.normalize(distance, halfWidth, halfHeight, farthest);
    }
}
