package rasterlab.app.visibility;

import rasterlab.app.canvas.Steps;
import rasterlab.engine.transform.SphericalView;

/** Turns the scene about its axis, θ by θ, as the step player plays it: 200 steps a turn. */
final class Turntable implements Steps {
    private static final int STEPS = 200;
    private static final double STEP = 2 * Math.PI / STEPS;

    private final VisibilityLabModel model;

    Turntable(VisibilityLabModel model) {
        this.model = model;
    }

    @Override
    public int first() {
        return 0;
    }

    @Override
    public int last() {
        return STEPS - 1;
    }

    @Override
    public int step() {
        double theta = model.state().choice().camera().thetaRadians();
        return Math.floorMod(Math.round(theta / STEP), STEPS);
    }

    @Override
    public void goTo(int step) {
        SphericalView camera = model.state().choice().camera();
        int next = Math.max(first(), Math.min(last(), step));
        model.look(new SphericalView(next * STEP, camera.phiRadians(), camera.rho()));
    }

    @Override
    public void rest() {
        model.count();
    }

    @Override
    public boolean turnsRound() {
        return true;
    }
}
