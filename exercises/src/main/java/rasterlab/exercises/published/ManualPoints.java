package rasterlab.exercises.published;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * Points that a teacher gave beside those of grading, or took.
 *
 * @param points negative where they were taken
 * @param reason in the teacher's words
 */
public record ManualPoints(int points, String reason) implements PublishedPart {
    @Override
    public void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeNumberField("points", points);
        out.writeStringField("reason", reason);
        out.writeEndObject();
    }

    /** The points with their sign, a minus as people write it. */
    public String signed() {
        return points < 0 ? "−" + -points : "+" + points;
    }
}
