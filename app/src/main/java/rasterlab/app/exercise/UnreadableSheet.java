package rasterlab.app.exercise;

import java.io.IOException;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.predicting.HandedAnswers;

/**
 * The server would refuse a sheet; it is not sent, since here it is told in the window's language.
 */
final class UnreadableSheet extends IOException {
    private static final long serialVersionUID = 1L;

    private final transient CatalogueException invalid;

    private UnreadableSheet(CatalogueException invalid) {
        super(invalid.getMessage(), invalid);
        this.invalid = invalid;
    }

    /**
     * Reads what is about to be handed in, if it is a sheet, as the server does.
     *
     * @throws UnreadableSheet if it is none
     */
    static void check(Exercise exercise, String text) throws UnreadableSheet {
        if (exercise.form() == TaskKind.PREDICT) read(exercise, text);
    }

    /**
     * Reads a sheet.
     *
     * @throws UnreadableSheet if it is none
     */
    static HandedAnswers read(Exercise exercise, String text) throws UnreadableSheet {
        try {
            return HandedAnswers.of(exercise, text.replaceFirst("^\uFEFF", ""));
        } catch (CatalogueException invalid) {
            throw new UnreadableSheet(invalid);
        }
    }

    Notice notice() {
        return Notice.quoting("sheet", LocalizedText.of(invalid::in));
    }
}
