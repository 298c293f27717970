package rasterlab.app.light;

import rasterlab.app.canvas.Steps;

/** Leads the selected lamp round the scene's vertical axis, 120 steps a turn. */
final class LampOrbit implements Steps {
    private static final int STEPS = 120;

    private final LightLabModel model;

    LampOrbit(LightLabModel model) {
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
        Lamp lamp = model.state().choice().lamp();
        double turn = Math.atan2(lamp.y(), lamp.x()) / (2 * Math.PI);
        return Math.floorMod(Math.round(turn * STEPS), STEPS);
    }

    @Override
    public void goTo(int step) {
        int next = Math.max(first(), Math.min(last(), step));
        double angle = 2 * Math.PI * next / STEPS;
        model.choose(
                choice -> {
                    Lamp lamp = choice.lamp();
                    double radius = Math.hypot(lamp.x(), lamp.y());
                    return choice.withLamp(
                            lamp.moved(
                                    radius * Math.cos(angle), radius * Math.sin(angle), lamp.z()));
                });
    }

    @Override
    public boolean turnsRound() {
        return true;
    }
}
