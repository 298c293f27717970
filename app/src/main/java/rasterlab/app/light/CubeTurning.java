package rasterlab.app.light;

import rasterlab.app.canvas.Steps;

/** Turns the colour cube about the vertical, 120 steps a turn. */
final class CubeTurning implements Steps {
    private static final int STEPS = 120;
    private static final double STEP = 2 * Math.PI / STEPS;

    private final LightLabModel model;

    CubeTurning(LightLabModel model) {
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
        return Math.floorMod(Math.round(model.state().colour().yaw() / STEP), STEPS);
    }

    @Override
    public void goTo(int step) {
        int next = Math.max(first(), Math.min(last(), step));
        model.colour(colour -> colour.turned(next * STEP - colour.yaw(), 0));
    }

    @Override
    public boolean turnsRound() {
        return true;
    }
}
