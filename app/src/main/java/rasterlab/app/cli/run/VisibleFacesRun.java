package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.faces.FaceWalk;
import rasterlab.engine.visibility.faces.SteppedVisibleFaces;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;

/**
 * Topic {@code visible-faces}: {@code vertices}, {@code faces}, {@code eye} and perhaps {@code
 * inside}; {@code visible} out, a truth value for each face.
 */
final class VisibleFacesRun implements TopicRun {
    private static final int MOST_CORNERS = 1_000_000;
    private static final JsonField<double[]> VERTICES =
            JsonField.required("vertices", json -> json.points(3, 0, PointJson.MOST));
    private static final JsonField<List<int[]>> FACES =
            JsonField.required(
                    "faces", json -> json.list("faces", VisibleFacesRun::face, 0, PointJson.MOST));
    private static final JsonField<double[]> EYE =
            JsonField.required("eye", json -> json.numbers(3, 3));
    private static final JsonField<double[]> INSIDE =
            JsonField.optional("inside", json -> json.numbers(3, 3));

    private final VisibleFacesTopic topic = new VisibleFacesTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    VisibleFacesRun(Watch watch) {
        this.watch = watch;
    }

    private static int[] face(StrictJson json) throws IOException {
        return json.list("vertex numbers", StrictJson::integer, 3, MOST_CORNERS).stream()
                .mapToInt(Integer::intValue)
                .toArray();
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"vertices":[[x,y,z],...], "faces":[[i,j,k,...],...], vertex numbers from 0, \
                counter-clockwise seen from outside, "eye":[x,y,z]} and perhaps \
                "inside":[x,y,z], an inner point, else the mean of the vertices""",
                """
                {"visible":[true,...]}, whether each face is turned towards the eye""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, VERTICES, FACES, EYE, INSIDE);
        VisibleFaces judge = topic.method(method).implementation();
        Body body = body(given);
        if (steps) return stepped(method, judge, body);
        boolean[] visible =
                watch.call(
                        method,
                        () -> judge.visible(body.xyz(), body.faces(), body.eye(), body.inside()));
        return json -> write(json, visible);
    }

    private static Body body(Given given) {
        int[][] faces = given.get(FACES).toArray(int[][]::new);
        double[] xyz = given.get(VERTICES);
        for (int f = 0; f < faces.length; f++) requireVertices(f, faces[f], xyz.length / 3);
        return new Body(xyz, faces, given.get(EYE), given.find(INSIDE).orElse(new double[0]));
    }

    private static void requireVertices(int face, int[] corners, int vertices) {
        for (int k = 0; k < corners.length; k++)
            if (corners[k] < 0 || corners[k] >= vertices)
                throw Complaint.badInput(
                        "/faces/%d/%d: expected the number of a vertex, %s, got %d"
                                .formatted(face, k, range(vertices), corners[k]));
    }

    private static String range(int vertices) {
        return vertices == 0 ? "of which there are none" : "from 0 to " + (vertices - 1);
    }

    private static void write(JsonGenerator json, boolean[] visible) throws IOException {
        json.writeArrayFieldStart("visible");
        for (boolean each : visible) json.writeBoolean(each);
        json.writeEndArray();
    }

    /** One face as the walk judged it. */
    private record Judged(int face, boolean visible, double value) {}

    private Answer stepped(String method, VisibleFaces judge, Body body) {
        SteppedVisibleFaces stepped = Steps.of(method, judge, SteppedVisibleFaces.class);
        List<Judged> all = watch.call(method, () -> judged(stepped.walk(body)));
        var visible = new boolean[all.size()];
        IntStream.range(0, visible.length).forEach(i -> visible[i] = all.get(i).visible);
        return json -> {
            write(json, visible);
            Steps.write(
                    json,
                    stepped.decision(),
                    all,
                    (out, step) -> {
                        out.writeNumberField("face", step.face);
                        JsonNumbers.writeField(out, "decision", step.value);
                        out.writeBooleanField("visible", step.visible);
                    });
        };
    }

    private static List<Judged> judged(FaceWalk walk) {
        var all = new ArrayList<Judged>();
        while (walk.advance()) all.add(new Judged(walk.face(), walk.visible(), walk.value()));
        return all;
    }
}
