package rasterlab.engine.transform;

import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * Makes the matrices from the world to the eye, in the textbook's reading order for row points.
 *
 * <p>Sources: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "view
 * transformation" (by spherical coordinates); the OpenGL Utility Library's gluLookAt.
 */
public final class ViewMatrices {
    private ViewMatrices() {}

    /**
     * VIEW_LEFT, VP_L: to the left-handed eye space, x right, y up, z forward. The eye is at ρ(sin
     * φ cos θ, sin φ sin θ, cos φ) and looks at the origin.
     *
     * @param theta θ, the longitude about the z axis
     * @param phi φ, from the z axis
     * @param rho ρ, the distance from the origin
     */
    public static Matrix4d left(Angle theta, Angle phi, double rho) {
        double st = theta.sin();
        double ct = theta.cos();
        double sp = phi.sin();
        double cp = phi.cos();
        return new Matrix4d(
                -st, -ct * cp, -ct * sp, 0, //
                ct, -st * cp, -st * sp, 0, //
                0, sp, -cp, 0, //
                0, 0, rho, 1);
    }

    /** VIEW_RIGHT, VP_R: the same with y down as on a screen, which makes it right-handed. */
    public static Matrix4d right(Angle theta, Angle phi, double rho) {
        return TextbookMatrices.scale(1, -1, 1).mul(left(theta, phi, rho));
    }

    /**
     * LOOKAT: to the right-handed eye space of OpenGL, x right, y up, z backward.
     *
     * @throws IllegalArgumentException where the eye is at the centre, or {@code up} is zero or
     *     within 10⁻⁸ radians of the line of sight
     */
    public static Matrix4d lookAt(Vector3d eye, Vector3d center, Vector3d up) {
        if (eye.equals(center))
            throw new IllegalArgumentException(
                    "center must differ from eye, got both " + text(eye));
        Vector3d forward = Directions.between(eye, center);
        if (up.x == 0 && up.y == 0 && up.z == 0)
            throw new IllegalArgumentException("up must not be zero, got " + text(up));
        Vector3d side = Directions.across(eye, center, up);
        if (side.length() < Directions.PARALLEL)
            throw new IllegalArgumentException(
                    "up must lie at least "
                            + Directions.PARALLEL
                            + " radians off the line of sight, got "
                            + text(up)
                            + " along "
                            + text(forward));
        side.normalize();
        Vector3d top = new Vector3d(side).cross(forward);
        double x = -side.dot(eye);
        double y = -top.dot(eye);
        double z = forward.dot(eye);
        Vector3d back = forward.negate(new Vector3d());
        return new Matrix4d(
                side.x, top.x, back.x, 0, //
                side.y, top.y, back.y, 0, //
                side.z, top.z, back.z, 0, //
                x, y, z, 1);
    }

    private static String text(Vector3d v) {
        return "(" + v.x + ", " + v.y + ", " + v.z + ")";
    }
}
