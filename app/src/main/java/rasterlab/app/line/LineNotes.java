package rasterlab.app.line;

import java.util.Optional;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.language.Texts;

/** One sentence over the stage where the picture alone would mislead. */
final class LineNotes {
    private LineNotes() {}

    static Optional<String> about(LineDrawings drawings, Texts texts) {
        LineDrawing drawing = drawings.drawing();
        String method = OwnWords.called(drawing.method(), texts.language());
        return switch (drawing.trace().ending()) {
            case ENDED ->
                    drawing.pixels() == 0
                            ? Optional.of(texts.text("note.nothing", method))
                            : drawings.tried().map(tried -> whose(tried, method, texts));
            case CUT -> Optional.of(cut(drawings, texts));
            case ENDLESS -> Optional.of(texts.text("note.endless", method, LineDrawing.LIMIT));
            case REFUSED ->
                    OwnWords.refusal(drawing.method(), drawing.trace().message(), texts.language())
                            .or(() -> Optional.of(texts.text("note.refused", method)));
            case CRASHED ->
                    Optional.of(texts.text("note.crashed", method, drawing.trace().message()));
        };
    }

    private static String cut(LineDrawings drawings, Texts texts) {
        long pixels = drawings.choice().segment().steps() + 1;
        return drawings.tried()
                .map(tried -> whose(tried, drawings.drawing().method(), texts))
                .map(whose -> texts.text("note.cut.tried", pixels, LineDrawing.LIMIT, whose))
                .orElseGet(() -> texts.text("note.cut", pixels, LineDrawing.LIMIT));
    }

    /** Says whose pixels are seen, and how many of the program's are known where not all are. */
    private static String whose(TrialSegment tried, String method, Texts texts) {
        if (tried.drawn().isEmpty()) return texts.text("note.tried.right", method);
        if (tried.drawn().get().pixels().size() == 0)
            return texts.text("note.tried.nothing", method);
        return tried.first().isEmpty()
                ? texts.text("note.tried", method)
                : texts.text("note.tried.first", method, tried.first().getAsInt());
    }
}
