package rasterlab.app.light.panel;

import rasterlab.app.canvas.player.TurnSteps;
import rasterlab.app.light.Lamp;
import rasterlab.app.light.LightLabModel;

/** Leads the selected lamp round the scene's vertical axis. */
public final class LampOrbit extends TurnSteps {
    private final LightLabModel model;

    public LampOrbit(LightLabModel model) {
        super(120);
        this.model = model;
    }

    @Override
    protected double turns() {
        Lamp lamp = model.state().choice().lamp();
        return Math.atan2(lamp.y(), lamp.x()) / (2 * Math.PI);
    }

    @Override
    protected void turnTo(double turns) {
        double angle = 2 * Math.PI * turns;
        model.choose(
                choice -> {
                    Lamp lamp = choice.lamp();
                    double radius = Math.hypot(lamp.x(), lamp.y());
                    return choice.withLamp(
                            lamp.moved(
                                    radius * Math.cos(angle), radius * Math.sin(angle), lamp.z()));
                });
    }
}
