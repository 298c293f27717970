package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.PointInPolygon;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.inside.EdgeWalk;
import rasterlab.engine.polygon.inside.PointInPolygonTopic;
import rasterlab.engine.polygon.inside.SteppedPolygonTest;
import rasterlab.engine.study.Topic;

/** Topic {@code point-in-polygon}: {@code polygon}, {@code points}; {@code inside} out. */
public final class PointInPolygonRun implements TopicRun {
    /** The most edges looked at whose steps are written. */
    private static final int MOST_STEPS = 1_000_000;

    private static final JsonField<double[]> POLYGON =
            JsonField.required(
                    "polygon", json -> json.points(2, 3, PointInTriangleRun.MOST_POINTS));
    private static final JsonField<double[]> POINTS =
            JsonField.required("points", json -> json.points(2, 0, PointInTriangleRun.MOST_POINTS));

    private final PointInPolygonTopic topic = new PointInPolygonTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    PointInPolygonRun(Watch watch) {
        this.watch = watch;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, POLYGON, POINTS);
        Points polygon = Points.of(given.get(POLYGON));
        Points points = Points.of(given.get(POINTS));
        double[] polygonX = polygon.xs();
        double[] polygonY = polygon.ys();
        PointInPolygon judge = topic.method(method).implementation();
        Membership inside =
                watch.call(
                        method,
                        () ->
                                new Membership(
                                        points,
                                        points.size(),
                                        (x, y) -> judge.contains(polygonX, polygonY, x, y)));
        if (!steps) return json -> PointInTriangleRun.write(json, inside);
        SteppedPolygonTest stepped = stepped(method, judge, polygon, points);
        return json -> {
            PointInTriangleRun.write(json, inside);
            json.writeStringField("decision", stepped.countFormula());
            writeSteps(json, stepped, polygon, points);
        };
    }

    private static SteppedPolygonTest stepped(
            String method, PointInPolygon judge, Points polygon, Points points) {
        if (!(judge instanceof SteppedPolygonTest stepped))
            throw Complaint.badInput("--steps: method '" + method + "' has no steps");
        long most = (long) polygon.size() * points.size();
        if (most > MOST_STEPS)
            throw Complaint.badInput(
                    "--steps: corners times points must be at most "
                            + MOST_STEPS
                            + ", got "
                            + most);
        return stepped;
    }

    /** For each point the edges looked at, each with the count after it. */
    private static void writeSteps(
            JsonGenerator json, SteppedPolygonTest stepped, Points polygon, Points points)
            throws IOException {
        double[] polygonX = polygon.xs();
        double[] polygonY = polygon.ys();
        json.writeArrayFieldStart("steps");
        for (int i = 0; i < points.size(); i++) {
            EdgeWalk walk = stepped.walk(polygonX, polygonY, points.x(i), points.y(i));
            json.writeStartArray();
            while (walk.advance()) {
                json.writeStartObject();
                json.writeNumberField("edge", walk.edge());
                json.writeNumberField("count", walk.count());
                json.writeEndObject();
            }
            json.writeEndArray();
        }
        json.writeEndArray();
    }
}
