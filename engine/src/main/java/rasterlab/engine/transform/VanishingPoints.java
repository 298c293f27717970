package rasterlab.engine.transform;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector4d;

/**
 * Where a central projection sends the axes' points at infinity, and from where it projects.
 *
 * <p>With p, q, r in the last column, [1 0 0 0] goes to [1 0 0 p]: all lines parallel to x meet in
 * x = 1/p, and the centre of projection for that axis is x = −1/p, where H = 0. Likewise y and z.
 * An axis whose number is 0 has neither: its parallels stay parallel.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "perspective
 * transformations", pp. 32–36.
 */
public final class VanishingPoints {
    private VanishingPoints() {}

    /**
     * The image of the infinitely far point of an axis.
     *
     * @param axis 0, 1 or 2 for x, y or z
     * @return empty where the image is infinitely far too
     */
    public static Optional<Vector3d> of(Matrix4d projection, int axis) {
        Vector4d row = projection.getColumn(checked(axis), new Vector4d());
        if (row.w == 0) return Optional.empty();
        // Adding 0 makes 0 of −0.
        return Optional.of(
                new Vector3d(row.x / row.w + 0.0, row.y / row.w + 0.0, row.z / row.w + 0.0));
    }

    /** The point of an axis with H = 0, from which points parallel to that axis are projected. */
    public static Optional<Vector3d> center(Matrix4d projection, int axis) {
        double along = projection.getColumn(checked(axis), new Vector4d()).w;
        double constant = projection.getColumn(3, new Vector4d()).w;
        if (along == 0) return Optional.empty();
        return Optional.of(new Vector3d().setComponent(axis, -constant / along));
    }

    private static int checked(int axis) {
        if (axis < 0 || axis > 2)
            throw new IllegalArgumentException("axis must be 0, 1 or 2, got " + axis);
        return axis;
    }
}
