package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.hidden.DrawnFaces;
import rasterlab.engine.visibility.hidden.HiddenSurfacesTopic;
import rasterlab.engine.visibility.hidden.SurfaceView;

/**
 * Topic {@code hidden-surfaces}: {@code vertices}, {@code faces}, where they are seen from, {@code
 * size}; {@code picture} out, the number of the face at each pixel, and what was counted.
 */
final class HiddenSurfacesRun implements TopicRun {
    private static final int MOST_CORNERS = 1_000_000;
    private static final double LARGEST_SCALE = 1e9;
    private static final JsonField<double[]> VERTICES =
            JsonField.required("vertices", json -> json.points(3, 0, PointJson.MOST));
    private static final JsonField<List<int[]>> FACES =
            JsonField.required(
                    "faces",
                    json -> json.list("faces", HiddenSurfacesRun::face, 0, PointJson.MOST));
    private static final JsonField<Double> THETA = JsonField.required("theta", StrictJson::number);
    private static final JsonField<Double> PHI = JsonField.required("phi", StrictJson::number);
    private static final JsonField<Double> RHO =
            JsonField.required(
                    "rho", json -> json.numberFrom(SphericalView.NEAREST, SphericalView.FARTHEST));
    private static final JsonField<int[]> SIZE =
            JsonField.required("size", json -> json.integers(2));
    private static final JsonField<String> PROJECTION =
            JsonField.optional("projection", json -> json.word(Projection.names()));
    private static final JsonField<Double> SCALE =
            JsonField.optional("scale", json -> json.numberAbove(0, LARGEST_SCALE));

    private final HiddenSurfacesTopic topic = new HiddenSurfacesTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    HiddenSurfacesRun(Watch watch) {
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
                flat, convex and counter-clockwise seen from outside, "theta":a, "phi":b, \
                "rho":r, angles in degrees, "size":[w,h]} and perhaps "projection":NAME, else \
                perspective, and "scale":pixels per unit, else 1""",
                """
                {"picture":[[f,...],...] rows of face numbers, -1 where there is none, \
                "splits":n, "work":{"comparisons":n,...}}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given =
                StrictJson.object(
                        text, length, VERTICES, FACES, THETA, PHI, RHO, SIZE, PROJECTION, SCALE);
        SurfaceView view = view(given);
        Visibility visibility = topic.method(method).implementation();
        if (steps) return stepped(method, visibility, view);
        DrawnFaces drawn = watch.call(method, () -> DrawnFaces.by(visibility, view));
        return json -> write(json, drawn);
    }

    private static SurfaceView view(Given given) {
        int[] size = given.get(SIZE);
        try {
            Raster.checkSize(size[0], size[1]);
            var mesh = new Mesh(given.get(VERTICES), given.get(FACES).toArray(int[][]::new));
            var camera =
                    new SphericalView(
                            Math.toRadians(given.get(THETA)),
                            Math.toRadians(given.get(PHI)),
                            given.get(RHO));
            return SurfaceView.of(
                    mesh,
                    camera,
                    given.find(PROJECTION).map(Projection::named).orElse(Projection.PERSPECTIVE),
                    new PictureFit(size[0], size[1], given.find(SCALE).orElse(1.0)));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    private static void write(JsonGenerator json, DrawnFaces drawn) throws IOException {
        json.writeArrayFieldStart("picture");
        for (int y = 0; y < drawn.picture().height(); y++) {
            json.writeStartArray();
            for (int x = 0; x < drawn.picture().width(); x++)
                json.writeNumber(drawn.picture().face(x, y));
            json.writeEndArray();
        }
        json.writeEndArray();
        json.writeNumberField("splits", drawn.work().splits());
        json.writeObjectFieldStart("work");
        for (Map.Entry<String, Long> counted : drawn.work().operations().entrySet())
            json.writeNumberField(counted.getKey().replace(' ', '-'), counted.getValue());
        json.writeEndObject();
    }

    private Answer stepped(String method, Visibility visibility, SurfaceView view) {
        SteppedVisibility stepped = Steps.of(method, visibility, SteppedVisibility.class);
        var all = new ArrayList<VisibilityStep>();
        DrawnFaces drawn =
                watch.call(
                        method,
                        () -> DrawnFaces.watched(stepped, view, step -> Steps.add(all, step)));
        return json -> {
            write(json, drawn);
            Steps.write(json, stepped.decision(), all, HiddenSurfacesRun::write);
        };
    }

    private static void write(JsonGenerator json, VisibilityStep step) throws IOException {
        if (step instanceof VisibilityStep.Drawn drawn) {
            json.writeNumberField("draw", drawn.face());
        } else if (step instanceof VisibilityStep.Moved moved) {
            json.writeNumberField("move", moved.face());
            json.writeNumberField("before", moved.before());
        } else if (step instanceof VisibilityStep.Cut cut) {
            json.writeNumberField("cut", cut.face());
            json.writeNumberField("by", cut.by());
        } else if (step instanceof VisibilityStep.Span span) {
            json.writeNumberField("span", span.face());
            json.writeNumberField("y", span.y());
            json.writeNumberField("from", span.from());
            json.writeNumberField("to", span.to());
        } else if (step instanceof VisibilityStep.Window window) {
            json.writeFieldName("window");
            json.writeArray(
                    new int[] {window.x(), window.y(), window.width(), window.height()}, 0, 4);
            json.writeBooleanField("divided", window.divided());
        }
        JsonNumbers.writeField(json, "decision", step.value());
    }
}
