package rasterlab.app.line;

import java.util.Optional;

/**
 * The figures' lab at one moment.
 *
 * @param scene the newest choice
 * @param drawn the scene that the drawings are of, maybe an earlier one
 * @param drawing by the chosen method
 * @param other by the second one, if one is compared
 * @param step pixels lit so far
 * @param arrangement changes when the stage should show everything again
 */
public record FigureState(
        FigureScene scene,
        FigureScene drawn,
        FigureDrawing drawing,
        Optional<FigureDrawing> other,
        int step,
        int arrangement) {
    /** Whether every pixel is lit, so that missing ones can be told. */
    boolean finished() {
        return step == drawing.steps();
    }
}
