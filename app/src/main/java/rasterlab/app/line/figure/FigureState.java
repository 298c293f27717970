package rasterlab.app.line.figure;

import java.util.Optional;

/**
 * The figures' lab at one moment.
 *
 * @param scene the newest choice
 * @param drawings the newest finished ones, maybe of an earlier choice
 * @param step pixels of the chosen method lit so far
 * @param arrangement changes when the stage should show everything again
 * @param sought changes when the figure may have left the sight where nobody has led it with the
 *     pointer or the keys: by a number that was typed, or by undo
 */
public record FigureState(
        FigureScene scene, FigureDrawings drawings, int step, int arrangement, int sought) {
    /** The scene that the drawings are of. */
    public FigureScene drawn() {
        return drawings.scene();
    }

    public FigureDrawing drawing() {
        return drawings.drawing();
    }

    /** The drawing of the second method, if one is compared. */
    public Optional<FigureDrawing> other() {
        return drawings.other();
    }

    /** Whether every pixel is lit, so that missing ones can be told. */
    public boolean finished() {
        return step == drawing().steps();
    }
}
