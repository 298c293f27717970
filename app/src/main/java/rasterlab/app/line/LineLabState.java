package rasterlab.app.line;

import java.util.Optional;
import rasterlab.engine.range.Bounds;

/**
 * The state that the lab shows at one moment.
 *
 * @param choice the newest one
 * @param drawings the newest finished ones, maybe of an earlier choice
 * @param step pixels of the drawing lit so far, in [min(1, all), all]
 * @param arrangement changes when the stage should show the whole segment again
 */
public record LineLabState(LineChoice choice, LineDrawings drawings, int step, int arrangement) {
    public LineLabState {
        int all = drawings.drawing().pixels();
        Bounds.require("step", step, Math.min(1, all), all);
    }

    /** The drawing of the chosen method. */
    public LineDrawing drawing() {
        return drawings.drawing();
    }

    /** The drawing of the second method, if one is compared. */
    public Optional<LineDrawing> other() {
        return drawings.other();
    }

    /** Whether every pixel is lit, so that missing ones can be told. */
    public boolean finished() {
        return step == drawing().pixels();
    }
}
