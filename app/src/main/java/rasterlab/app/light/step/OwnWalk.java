package rasterlab.app.light.step;

import java.util.OptionalInt;

/** How many of a program's answers are shown: all, until the user goes back. */
public final class OwnWalk {
    private final Runnable changed;
    private OptionalInt chosen = OptionalInt.empty();

    /**
     * @param changed run when others are shown
     */
    public OwnWalk(Runnable changed) {
        this.changed = changed;
    }

    /** The step, in [0, count]. */
    public int step(int count) {
        return Math.min(count, chosen.orElse(count));
    }

    /** Shows the answers up to a step; from the last one on all of whatever there will be. */
    void goTo(int step, int count) {
        chosen = step < count ? OptionalInt.of(Math.max(0, step)) : OptionalInt.empty();
        changed.run();
    }

    /** Shows all, once something else is shown. */
    public void reset() {
        chosen = OptionalInt.empty();
    }
}
