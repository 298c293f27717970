package rasterlab.app.opengl;

import rasterlab.app.canvas.Steps;

/** Turns the scene about its upright axis as the step player plays it: 180 steps a turn. */
final class Turntable implements Steps {
    private static final int STEPS = 180;
    private static final double STEP = 360.0 / STEPS;

    private final OpenGlLabModel model;

    Turntable(OpenGlLabModel model) {
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
        return Math.floorMod(Math.round(model.state().choice().turn() / STEP), STEPS);
    }

    @Override
    public void goTo(int step) {
        int next = Math.max(first(), Math.min(last(), step));
        model.move(choice -> choice.turned(next * STEP - choice.turn(), 0));
    }

    @Override
    public boolean turnsRound() {
        return true;
    }
}
