package rasterlab.exercises.published;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.engine.range.Bounds;
import rasterlab.exercises.score.Diagnostic;

/**
 * A message about a place in what was handed in.
 *
 * @param line from 1; 0 where no line is known
 * @param column from 1; 0 where no column is known
 */
public record PublishedDiagnostic(int line, int column, String message) implements PublishedPart {
    public PublishedDiagnostic {
        Bounds.requireAtLeast("line", line, 0);
        Bounds.requireAtLeast("column", column, 0);
    }

    /**
     * The message in that language.
     *
     * @param language such as "ru"
     */
    public static PublishedDiagnostic of(Diagnostic said, String language) {
        return new PublishedDiagnostic(said.line(), said.column(), said.message(language));
    }

    @Override
    public void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeNumberField("line", line);
        out.writeNumberField("column", column);
        out.writeStringField("message", message);
        out.writeEndObject();
    }
}
