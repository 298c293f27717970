package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.triangle.PointInTriangleTopic;
import rasterlab.engine.study.Topic;

/** Topic {@code point-in-triangle}: {@code triangle}, {@code points}; {@code inside} out. */
public final class PointInTriangleRun implements TopicRun {
    /** The most points in one input. */
    static final int MOST_POINTS = 10_000_000;

    private static final JsonField<double[]> TRIANGLE =
            JsonField.required("triangle", json -> json.points(2, 3, 3));
    private static final JsonField<double[]> POINTS =
            JsonField.required("points", json -> json.points(2, 0, MOST_POINTS));

    private final PointInTriangleTopic topic = new PointInTriangleTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    PointInTriangleRun(Watch watch) {
        this.watch = watch;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, TRIANGLE, POINTS);
        if (steps) throw Complaint.badInput("--steps: method '" + method + "' has no steps");
        double[] t = given.get(TRIANGLE);
        Points points = Points.of(given.get(POINTS));
        PointInTriangle triangle = topic.method(method).implementation();
        Membership inside =
                watch.call(
                        method,
                        () ->
                                new Membership(
                                        points,
                                        points.size(),
                                        (x, y) ->
                                                triangle.contains(
                                                        t[0], t[1], t[2], t[3], t[4], t[5], x, y)));
        return json -> write(json, inside);
    }

    /** Writes field {@code inside}: true or false for each point. */
    static void write(JsonGenerator json, Membership inside) throws IOException {
        json.writeArrayFieldStart("inside");
        for (int i = 0; i < inside.size(); i++) json.writeBoolean(inside.inside(i));
        json.writeEndArray();
    }
}
