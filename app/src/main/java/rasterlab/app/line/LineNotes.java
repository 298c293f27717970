package rasterlab.app.line;

import java.util.Optional;
import rasterlab.app.language.Texts;

/** One sentence over the stage where the picture alone would mislead. */
final class LineNotes {
    private LineNotes() {}

    static Optional<String> about(LineDrawings drawings, Texts texts) {
        LineDrawing drawing = drawings.drawing();
        String method = drawing.method();
        return switch (drawing.trace().ending()) {
            case ENDED ->
                    drawing.pixels() == 0
                            ? Optional.of(texts.text("note.nothing", method))
                            : drawings.tried().map(tried -> texts.text(whose(tried), method));
            case CUT ->
                    Optional.of(
                            texts.text(
                                    "note.cut",
                                    drawings.choice().segment().steps() + 1,
                                    LineDrawing.LIMIT));
            case ENDLESS -> Optional.of(texts.text("note.endless", method, LineDrawing.LIMIT));
            case REFUSED -> Optional.of(texts.text("note.refused", method));
            case CRASHED ->
                    Optional.of(texts.text("note.crashed", method, drawing.trace().message()));
        };
    }

    /** Key of the sentence that says whose pixels are seen. */
    private static String whose(Tried tried) {
        if (tried.drawn().isEmpty()) return "note.tried.right";
        return tried.drawn().get().size() == 0 ? "note.tried.nothing" : "note.tried";
    }
}
