package rasterlab.app.light.panel;

import rasterlab.app.canvas.player.TurnSteps;
import rasterlab.app.light.LightLabModel;

/** Turns the colour cube about the vertical. */
final class CubeTurning extends TurnSteps {
    private final LightLabModel model;

    CubeTurning(LightLabModel model) {
        super(120);
        this.model = model;
    }

    @Override
    protected double turns() {
        return model.state().color().yaw() / (2 * Math.PI);
    }

    @Override
    protected void turnTo(double turns) {
        model.color(color -> color.turned(2 * Math.PI * turns - color.yaw(), 0));
    }
}
