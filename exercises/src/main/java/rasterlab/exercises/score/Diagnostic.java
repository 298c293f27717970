package rasterlab.exercises.score;

/**
 * A message about a place in the student's source.
 *
 * @param line from 1; 0 where no line is known
 * @param column from 1; 0 where no column is known
 * @param message may have several lines
 */
public record Diagnostic(int line, int column, String message) {
    public Diagnostic {
        message = VisibleText.lines(message);
    }
}
