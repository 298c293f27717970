package rasterlab.app.clip;

import java.util.Optional;
import rasterlab.app.clip.outcome.ClipResults;
import rasterlab.app.clip.outcome.ClipStep;
import rasterlab.app.clip.scene.ClipGrip;
import rasterlab.engine.range.Bounds;

/**
 * The state that the lab shows at one moment.
 *
 * @param choice the newest one
 * @param results the newest finished ones, maybe of an earlier choice
 * @param step 0 before the first step of the method, its number while it is looked at, one more
 *     than there are for the result
 * @param selected the point whose coordinates are shown
 * @param arrangement changes when the stage should show everything again
 */
public record ClipLabState(
        ClipChoice choice, ClipResults results, int step, ClipGrip selected, int arrangement) {
    public ClipLabState {
        Bounds.requireAtLeast("step", step, 0);
    }

    /** Whether the result is shown. */
    public boolean finished() {
        return step > results.clipping().steps().size();
    }

    /** The step that is looked at, if any is. */
    public Optional<ClipStep> current() {
        return step == 0 || finished()
                ? Optional.empty()
                : Optional.of(results.clipping().steps().get(step - 1));
    }
}
