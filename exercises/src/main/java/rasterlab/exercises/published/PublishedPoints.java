package rasterlab.exercises.published;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.engine.geometry.Bounds;
import rasterlab.exercises.score.ScorePoints;

/**
 * Points with their sum.
 *
 * @param hints points that hints cost, which the sum has no more
 * @param total what is left of the sum, at least 0
 */
public record PublishedPoints(int accuracy, int stability, int speed, int hints, int total, int of)
        implements PublishedPart {
    public PublishedPoints {
        Bounds.requireAtLeast("total", total, 0);
    }

    public static PublishedPoints of(ScorePoints points) {
        return of(points, 0);
    }

    /** The same, less the points that hints cost. */
    public static PublishedPoints of(ScorePoints points, int hints) {
        return new PublishedPoints(
                points.accuracy(),
                points.stability(),
                points.speed(),
                hints,
                Math.max(0, points.total() - hints),
                points.of());
    }

    @Override
    public void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeNumberField("accuracy", accuracy);
        out.writeNumberField("stability", stability);
        out.writeNumberField("speed", speed);
        if (hints > 0) out.writeNumberField("hints", hints);
        out.writeNumberField("total", total);
        out.writeNumberField("of", of);
        out.writeEndObject();
    }
}
