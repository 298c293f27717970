package rasterlab.app.opengl;

import rasterlab.app.canvas.player.TurnSteps;

/** Turns the scene about its upright axis as the step player plays it. */
final class GlTurntable extends TurnSteps {
    private final OpenGlLabModel model;

    GlTurntable(OpenGlLabModel model) {
        super(180);
        this.model = model;
    }

    @Override
    protected double turns() {
        return model.state().choice().turn() / 360;
    }

    @Override
    protected void turnTo(double turns) {
        model.move(choice -> choice.turned(360 * turns - choice.turn(), 0));
    }
}
