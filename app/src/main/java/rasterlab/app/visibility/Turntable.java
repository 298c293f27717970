package rasterlab.app.visibility;

import rasterlab.app.canvas.player.TurnSteps;
import rasterlab.engine.transform.SphericalView;

/** Turns the scene about its axis, θ by θ, as the step player plays it. */
final class Turntable extends TurnSteps {
    private final VisibilityLabModel model;

    Turntable(VisibilityLabModel model) {
        super(200);
        this.model = model;
    }

    @Override
    protected double turns() {
        return model.state().choice().camera().thetaRadians() / (2 * Math.PI);
    }

    @Override
    protected void turnTo(double turns) {
        SphericalView camera = model.state().choice().camera();
        model.look(new SphericalView(2 * Math.PI * turns, camera.phiRadians(), camera.rho()));
    }

    @Override
    public void rest() {
        model.count();
    }
}
