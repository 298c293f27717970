package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.Triangulator;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.triangulation.SteppedTriangulator;
import rasterlab.engine.polygon.triangulation.TriangleWalk;
import rasterlab.engine.polygon.triangulation.TriangulateTopic;
import rasterlab.engine.study.Topic;

/** Topic {@code triangulate}: {@code polygon}; {@code triangles} out, corner numbers from 0. */
public final class TriangulateRun implements TopicRun {
    private static final String VALUE = "; the value is the squared length of the diagonal";
    private static final JsonField<double[]> POLYGON =
            JsonField.required("polygon", json -> json.points(2, 3, PointJson.MOST));

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
    public Form form() {
        return new Form(
                """
                {"polygon":[[x,y],...]}""",
                """
                {"triangles":[[i,j,k],...]}, corner numbers from 0, counter-clockwise with y \
                up""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, POLYGON);
        Points polygon = Points.of(given.get(POLYGON));
        Triangulator triangulator = topic.method(method).implementation();
        if (steps) return stepped(method, triangulator, polygon);
        int[] triples =
                watch.call(method, () -> triangulator.triangulate(polygon.xs(), polygon.ys()));
        return json -> {
            json.writeArrayFieldStart("triangles");
            for (int i = 0; i < triples.length; i += 3) json.writeArray(triples, i, 3);
            json.writeEndArray();
        };
    }

    /**
     * A triangle that is cut off.
     *
     * @param decision squared length of the diagonal a–c
     */
    private record Cut(int a, int b, int c, double decision) {
        void write(JsonGenerator json) throws IOException {
            json.writeNumberField("cut", b);
            json.writeFieldName("diagonal");
            json.writeArray(new int[] {a, c}, 0, 2);
            JsonNumbers.writeField(json, "decision", decision);
        }
    }

    private Answer stepped(String method, Triangulator triangulator, Points polygon) {
        SteppedTriangulator stepped = Steps.of(method, triangulator, SteppedTriangulator.class);
        List<Cut> cuts = watch.call(method, () -> cuts(stepped, polygon));
        return json -> {
            json.writeArrayFieldStart("triangles");
            for (Cut cut : cuts) json.writeArray(new int[] {cut.a, cut.b, cut.c}, 0, 3);
            json.writeEndArray();
            Steps.write(json, stepped.choice() + VALUE, cuts, (out, cut) -> cut.write(out));
        };
    }

    private static List<Cut> cuts(SteppedTriangulator stepped, Points polygon) {
        var cuts = new ArrayList<Cut>();
        TriangleWalk walk = stepped.walk(polygon.xs(), polygon.ys());
        while (walk.advance()) {
            double dx = polygon.x(walk.c()) - polygon.x(walk.a());
            double dy = polygon.y(walk.c()) - polygon.y(walk.a());
            cuts.add(new Cut(walk.a(), walk.b(), walk.c(), dx * dx + dy * dy));
        }
        return cuts;
    }
}
