package rasterlab.app.line;

import java.util.Optional;

/**
 * What the lab shows at one moment.
 *
 * @param drawing what the chosen method draws
 * @param other what the second method draws, if one is compared
 * @param step pixels lit so far, in [min(1, all), all]
 * @param undoable whether there is something to undo
 * @param arrangement changes when the stage should show the whole segment again
 */
public record LineLabState(
        LineChoice choice,
        LineDrawing drawing,
        Optional<LineDrawing> other,
        int step,
        boolean undoable,
        int arrangement) {
    /** Whether every pixel is lit, so that missing ones can be told. */
    public boolean finished() {
        return step == drawing.pixels();
    }
}
