package rasterlab.engine.transform;

import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * An eye at e = ρ(sin φ cos θ, sin φ sin θ, cos φ) that looks at the origin.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, "view
 * transformation"; the vase coursework uses the same matrix.
 *
 * @param thetaRadians θ, the eye's longitude about the z axis, any finite angle
 * @param phiRadians φ, the angle between the z axis and the direction to the eye, any finite angle
 * @param rho ρ, the eye's distance from the origin, {@value #NEAREST} to {@value #FARTHEST} world
 *     units
 */
public record SphericalView(double thetaRadians, double phiRadians, double rho) {
    /** Smallest ρ, in world units. */
    public static final double NEAREST = 0.001;

    /** Largest ρ, in world units: beyond it a float depth tells a scene's faces no longer apart. */
    public static final double FARTHEST = 1e6;

    public SphericalView {
        requireFinite("theta", thetaRadians);
        requireFinite("phi", phiRadians);
        if (!(rho >= NEAREST && rho <= FARTHEST))
            throw new IllegalArgumentException(
                    "rho must be from 0.001 to 1000000 units, got " + rho);
    }

    /**
     * VP_L, from world to the left-handed eye space (x right, y up, z forward), in the textbook's
     * layout for row points:
     *
     * <pre>
     *  −sin θ   −cos θ cos φ   −cos θ sin φ   0
     *   cos θ   −sin θ cos φ   −sin θ sin φ   0
     *     0         sin φ         −cos φ      0
     *     0           0              ρ        1
     * </pre>
     */
    public Matrix4d matrix() {
        return ViewMatrices.left(Angle.ofRadians(thetaRadians), Angle.ofRadians(phiRadians), rho);
    }

    /** The eye in world coordinates. */
    public Vector3d eye() {
        double sp = Math.sin(phiRadians);
        return new Vector3d(
                rho * sp * Math.cos(thetaRadians),
                rho * sp * Math.sin(thetaRadians),
                rho * Math.cos(phiRadians));
    }

    /**
     * This eye with the world's z axis pointing up in the picture.
     *
     * <p>Where sin φ &lt; 0 the matrix's y axis points down the world's z axis, and a picture drawn
     * with y upwards stands on its head. (θ + π, −φ) is the same eye, turned upright. The vase's
     * coursework has φ = 4π/3 and looks upright because it never flips y on the screen, which
     * mirrors its picture.
     */
    public SphericalView upright() {
        if (Math.sin(phiRadians) >= 0) return this;
        double phi = Math.IEEEremainder(phiRadians, 2 * Math.PI);
        return new SphericalView(thetaRadians + Math.PI, -phi, rho);
    }

    private static void requireFinite(String name, double radians) {
        if (!Double.isFinite(radians))
            throw new IllegalArgumentException(
                    name + " must be a finite angle in radians, got " + radians);
    }
}
