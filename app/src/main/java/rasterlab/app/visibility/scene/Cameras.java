package rasterlab.app.visibility.scene;

import rasterlab.engine.transform.SphericalView;

/** Moves of the eye. */
public final class Cameras {
    /** Nearest and farthest eye, as shares of the scene's first ρ. */
    private static final double NEAREST = 0.45;

    private static final double FARTHEST = 8;

    private Cameras() {}

    public static SphericalView turned(SphericalView camera, double dTheta, double dPhi) {
        return new SphericalView(
                wrapped(camera.thetaRadians() + dTheta),
                wrapped(camera.phiRadians() + dPhi),
                camera.rho());
    }

    /** The camera moved away or nearer, within the distances that suit the scene. */
    public static SphericalView dollied(VisibilityChoice choice, double factor) {
        SphericalView camera = choice.camera();
        double first = choice.shown().scene().defaultCamera().rho();
        double rho = Math.max(NEAREST * first, Math.min(FARTHEST * first, camera.rho() * factor));
        return new SphericalView(camera.thetaRadians(), camera.phiRadians(), rho);
    }

    /** The angle in [0, 2π). */
    private static double wrapped(double radians) {
        double turn = 2 * Math.PI;
        double rest = radians - turn * Math.floor(radians / turn);
        return rest < turn ? rest : 0;
    }
}
