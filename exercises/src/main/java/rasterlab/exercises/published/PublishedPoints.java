package rasterlab.exercises.published;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import rasterlab.engine.range.Bounds;
import rasterlab.exercises.score.ScorePoints;

/**
 * Points with their sum.
 *
 * @param hints points that hints cost, which the sum has no more
 * @param late points that lateness cost, which the sum has no more either
 * @param manual what a teacher gave or took, which the sum has too
 * @param total what is left of the sum, at least 0
 */
public record PublishedPoints(
        int accuracy,
        int stability,
        int speed,
        int hints,
        int late,
        List<ManualPoints> manual,
        int total,
        int of)
        implements PublishedPart {
    public PublishedPoints {
        Bounds.requireAtLeast("total", total, 0);
        manual = List.copyOf(manual);
    }

    public static PublishedPoints of(ScorePoints points) {
        return of(points, 0, 0, List.of());
    }

    /**
     * The points, less those that hints cost, then less those for lateness, and then with what a
     * teacher gave or took.
     *
     * @param percent that lateness costs of what is left beside hints, from 0 to 100; rounded down
     *     to whole points
     */
    public static PublishedPoints of(
            ScorePoints points, int hints, int percent, List<ManualPoints> manual) {
        Bounds.require("percent", percent, 0, 100);
        int graded = Math.max(0, points.total() - hints);
        int late = graded * percent / 100;
        int given = manual.stream().mapToInt(ManualPoints::points).sum();
        return new PublishedPoints(
                points.accuracy(),
                points.stability(),
                points.speed(),
                hints,
                late,
                manual,
                Math.max(0, graded - late + given),
                points.of());
    }

    @Override
    public void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        out.writeNumberField("accuracy", accuracy);
        out.writeNumberField("stability", stability);
        out.writeNumberField("speed", speed);
        if (hints > 0) out.writeNumberField("hints", hints);
        if (late > 0) out.writeNumberField("late", late);
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
