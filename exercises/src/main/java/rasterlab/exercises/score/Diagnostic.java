package rasterlab.exercises.score;

import rasterlab.engine.range.Bounds;

/**
 * A message about a place in the student's source.
 *
 * @param line from 1; 0 where no line is known
 * @param column from 1; 0 where no column is known
 */
public record Diagnostic(int line, int column, Message explanation) {
    public Diagnostic {
        Bounds.requireAtLeast("line", line, 0);
        Bounds.requireAtLeast("column", column, 0);
    }

    /** The diagnostic in English; may have several lines. */
    public String message() {
        return message("en");
    }

    /** The diagnostic in a language. */
    public String message(String language) {
        return explanation.in(language);
    }
}
