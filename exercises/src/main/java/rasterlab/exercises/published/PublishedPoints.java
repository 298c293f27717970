package rasterlab.exercises.published;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.exercises.score.Points;

/** Points with their sum. */
public record PublishedPoints(int accuracy, int stability, int speed, int total, int of)
        implements PublishedPart {
    public static PublishedPoints of(Points points) {
        return new PublishedPoints(
                points.accuracy(), points.stability(), points.speed(), points.total(), points.of());
    }

    @Override
    public void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeNumberField("accuracy", accuracy);
        out.writeNumberField("stability", stability);
        out.writeNumberField("speed", speed);
        out.writeNumberField("total", total);
        out.writeNumberField("of", of);
        out.writeEndObject();
    }
}
