package rasterlab.exercises.published;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import rasterlab.engine.geometry.Bounds;
import rasterlab.exercises.score.ScorePoints;

/**
 * Points with their sum.
 *
 * @param hints points that hints cost, which the sum has no more
 * @param manual what a teacher gave or took, which the sum has too
 * @param total what is left of the sum, at least 0
 */
public record PublishedPoints(
        int accuracy,
        int stability,
        int speed,
        int hints,
        List<ManualPoints> manual,
        int total,
        int of)
        implements PublishedPart {
    public PublishedPoints {
        Bounds.requireAtLeast("total", total, 0);
        manual = List.copyOf(manual);
    }

    public static PublishedPoints of(ScorePoints points) {
        return of(points, 0, List.of());
    }

    /** The points, less the points that hints cost, and then with what a teacher gave or took. */
    public static PublishedPoints of(ScorePoints points, int hints, List<ManualPoints> manual) {
        int graded = Math.max(0, points.total() - hints);
        int given = manual.stream().mapToInt(ManualPoints::points).sum();
        return new PublishedPoints(
                points.accuracy(),
                points.stability(),
                points.speed(),
                hints,
                manual,
                Math.max(0, graded + given),
                points.of());
    }

    @Override
    public void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeNumberField("accuracy", accuracy);
        out.writeNumberField("stability", stability);
        out.writeNumberField("speed", speed);
        if (hints > 0) out.writeNumberField("hints", hints);
        if (!manual.isEmpty()) {
            out.writeArrayFieldStart("manual");
            for (ManualPoints one : manual) one.write(out);
            out.writeEndArray();
        }
        out.writeNumberField("total", total);
        out.writeNumberField("of", of);
        out.writeEndObject();
    }
}
