package rasterlab.app.visibility;

import rasterlab.app.canvas.player.Steps;

/** The steps of the chosen method, or the turning scene, as the timeline plays them. */
final class DrawingSteps implements Steps {
    private final VisibilityLabModel model;
    private final Turntable turntable;

    DrawingSteps(VisibilityLabModel model) {
        this.model = model;
        turntable = new Turntable(model);
    }

    private boolean turning() {
        return !model.state().choice().drawing();
    }

    @Override
    public int last() {
        return turning() ? turntable.last() : model.lastStep();
    }

    @Override
    public int step() {
        return turning() ? turntable.step() : Math.min(model.state().step(), last());
    }

    @Override
    public void goTo(int step) {
        if (turning()) turntable.goTo(step);
        else model.goTo(step);
    }

    @Override
    public void rest() {
        if (turning()) turntable.rest();
    }

    @Override
    public boolean turnsRound() {
        return turning();
    }
}
