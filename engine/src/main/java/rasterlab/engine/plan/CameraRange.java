package rasterlab.engine.plan;

import rasterlab.engine.range.Bounds;
import rasterlab.engine.transform.SphericalView;

/**
 * The cameras for which a plan's proofs hold.
 *
 * @param at the camera it was made for
 * @param turn how far the direction to the eye may turn from there, in radians, at least 0
 * @param zoom the largest factor of ρ, either way, at least 1
 */
public record CameraRange(SphericalView at, double turn, double zoom) {
    /** The usual room: 2 degrees, 5 %. */
    static final double TURN = Math.toRadians(2);

    static final double ZOOM = 1.05;

    /**
     * The room of a plan that has fewer faces within the outline, so that few pictures need one.
     */
    static final double OUTLINE = Math.toRadians(8);

    /** The room of a plan whose proofs hold from all around: farther off, its costs are others. */
    static final double WIDE = Math.toRadians(30);

    public CameraRange {
        Bounds.requireAtLeast("turn", turn, 0);
        Bounds.requireAtLeast("zoom", zoom, 1);
    }

    /** The cameras at about one's distance that have turned by at most an angle, in radians. */
    static CameraRange turned(SphericalView at, double turn) {
        return new CameraRange(at, turn, ZOOM);
    }

    /** One camera alone. */
    static CameraRange only(SphericalView at) {
        return new CameraRange(at, 0, 1);
    }

    public boolean within(SphericalView camera) {
        if (camera.equals(at)) return true;
        double apart = at.eye().angle(camera.eye());
        double factor = camera.rho() / at.rho();
        // Over the pole the picture turns about the line of sight; near it so does every step.
        double round =
                Math.abs(
                        Math.IEEEremainder(camera.thetaRadians() - at.thetaRadians(), 2 * Math.PI));
        return apart <= turn && round <= turn && factor <= zoom && 1 / factor <= zoom;
    }
}
