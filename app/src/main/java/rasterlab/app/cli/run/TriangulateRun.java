package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.Triangulator;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.triangulation.SteppedTriangulator;
import rasterlab.engine.polygon.triangulation.TriangulateTopic;
import rasterlab.engine.study.Topic;

/** Topic {@code triangulate}: {@code polygon}; {@code triangles} out, corner numbers from 0. */
public final class TriangulateRun implements TopicRun {
    private static final JsonField<double[]> POLYGON =
            JsonField.required(
                    "polygon", json -> json.points(2, 3, PointInTriangleRun.MOST_POINTS));

    private final TriangulateTopic topic = new TriangulateTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    TriangulateRun(Watch watch) {
        this.watch = watch;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, POLYGON);
        Points polygon = Points.of(given.get(POLYGON));
        Triangulator triangulator = topic.method(method).implementation();
        int[] triples =
                watch.call(method, () -> triangulator.triangulate(polygon.xs(), polygon.ys()));
        if (!steps) return json -> writeTriangles(json, triples);
        if (!(triangulator instanceof SteppedTriangulator stepped))
            throw Complaint.badInput("--steps: method '" + method + "' has no steps");
        return json -> {
            writeTriangles(json, triples);
            json.writeStringField("decision", stepped.choice());
            writeSteps(json, triples);
        };
    }

    private static void writeTriangles(JsonGenerator json, int[] triples) throws IOException {
        json.writeArrayFieldStart("triangles");
        for (int i = 0; i < triples.length; i += 3) json.writeArray(triples, i, 3);
        json.writeEndArray();
    }

    /** The triangles are the steps, in the order in which they are cut. */
    private static void writeSteps(JsonGenerator json, int[] triples) throws IOException {
        json.writeArrayFieldStart("steps");
        for (int i = 0; i < triples.length; i += 3) {
            json.writeStartObject();
            json.writeNumberField("cut", triples[i + 1]);
            json.writeFieldName("diagonal");
            json.writeArray(new int[] {triples[i], triples[i + 2]}, 0, 2);
            json.writeEndObject();
        }
        json.writeEndArray();
    }
}
