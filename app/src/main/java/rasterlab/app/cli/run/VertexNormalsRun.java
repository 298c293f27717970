package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.normals.NormalsWalk;
import rasterlab.engine.light.normals.SteppedNormals;
import rasterlab.engine.light.normals.Triangles;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;

/** Topic {@code vertex-normals}: {@code vertices}, {@code triangles}; {@code normals} out. */
final class VertexNormalsRun implements TopicRun {
    /** The most corners whose steps one answer has. */
    private static final int MOST_STEPPED = 300_000;

    private static final JsonField<double[]> VERTICES =
            JsonField.required("vertices", json -> json.points(3, 0, PointJson.MOST));
    private static final JsonField<List<int[]>> TRIANGLES =
            JsonField.required(
                    "triangles",
                    json -> json.list("triangles", each -> each.integers(3), 0, PointJson.MOST));

    private final Topic<VertexNormals, Triangles, Images> topic = new NormalsTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    VertexNormalsRun(Watch watch) {
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
                {"vertices":[[x,y,z],...], "triangles":[[i,j,k],...]}, vertex numbers from 0, \
                counter-clockwise seen from outside""",
                """
                {"normals":[[x,y,z],...]}, [0,0,0] where there is none""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Triangles surface = surface(StrictJson.object(text, length, VERTICES, TRIANGLES));
        VertexNormals normals = topic.method(method).implementation();
        if (steps) return stepped(method, normals, surface);
        Images images = watch.call(method, () -> topic.record(normals, surface, Integer.MAX_VALUE));
        return json -> {
            json.writeFieldName("normals");
            JsonNumbers.writePoints(json, images.coordinates(), 3);
        };
    }

    /** A face's normal added to a vertex's sum. */
    private record Step(int face, int vertex, double weight, double[] sum) {
        void write(JsonGenerator json) throws IOException {
            json.writeNumberField("face", face);
            json.writeNumberField("vertex", vertex);
            JsonNumbers.writeField(json, "decision", weight);
            json.writeFieldName("sum");
            JsonNumbers.write(json, sum);
        }
    }

    private Answer stepped(String method, VertexNormals normals, Triangles surface) {
        SteppedNormals stepped = Steps.of(method, normals, SteppedNormals.class);
        Steps.requireAtMost(MOST_STEPPED, "corners of triangles", surface.triangles().length);
        NormalsWalk walk = stepped.walk(surface.vertices(), surface.triangles());
        var steps = new ArrayList<Step>();
        double[] found =
                watch.call(
                        method,
                        () -> {
                            while (walk.advance())
                                steps.add(
                                        new Step(
                                                walk.face(),
                                                walk.vertex(),
                                                walk.weight(),
                                                walk.sum()));
                            return walk.normals();
                        });
        return json -> {
            json.writeFieldName("normals");
            JsonNumbers.writePoints(json, found, 3);
            Steps.write(json, stepped.weightFormula(), steps, (out, step) -> step.write(out));
        };
    }

    private static Triangles surface(Given given) {
        int[] corners = given.get(TRIANGLES).stream().flatMapToInt(Arrays::stream).toArray();
        try {
            return new Triangles(given.get(VERTICES), corners);
        } catch (IllegalArgumentException e) {
            throw EngineRefusal.complaint(e);
        }
    }
}
