package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.PolygonClipper;
import rasterlab.engine.clip.polygon.PolygonClipTopic;
import rasterlab.engine.clip.polygon.PolygonInWindow;
import rasterlab.engine.clip.polygon.PolygonWalk;
import rasterlab.engine.clip.polygon.SteppedPolygonClipper;
import rasterlab.engine.study.Topic;

/**
 * Topic {@code clip-polygon}: {@code window} as [xmin,ymin,xmax,ymax] or the corners of a convex
 * polygon, {@code polygon}; {@code polygons} out.
 */
public final class ClipPolygonRun implements TopicRun {
    private static final String DECISION = "how many corners the step leaves";
    private static final JsonField<WindowJson> WINDOW = WindowJson.field();
    private static final JsonField<double[]> POLYGON =
            JsonField.required("polygon", json -> json.points(2, 0, ClipRun.MOST));

    private final PolygonClipTopic topic = new PolygonClipTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    ClipPolygonRun(Watch watch) {
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
                {"window":[xmin,ymin,xmax,ymax], "polygon":[[x,y],...]}, or for a window the \
                corners of a convex polygon""",
                """
                {"polygons":[[[x,y],...],...]}, counter-clockwise""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, WINDOW, POLYGON);
        var input = new PolygonInWindow(given.get(WINDOW).corners(), given.get(POLYGON));
        PolygonClipper clipper = topic.method(method).implementation();
        return watch.call(method, () -> clipped(method, clipper, input, steps));
    }

    private Answer clipped(
            String method, PolygonClipper clipper, PolygonInWindow input, boolean steps) {
        List<Step> walk =
                steps
                        ? steps(Steps.of(method, clipper, SteppedPolygonClipper.class), input)
                        : List.of();
        List<double[]> pieces = topic.record(clipper, input, Integer.MAX_VALUE);
        return json -> {
            writePieces(json, pieces);
            if (steps) Steps.write(json, DECISION, walk, (out, step) -> step.write(out));
        };
    }

    private record Step(String at, double[] polygon) {
        void write(JsonGenerator json) throws IOException {
            json.writeStringField("at", at);
            json.writeNumberField("decision", polygon.length / 2);
            json.writeFieldName("polygon");
            JsonNumbers.writePoints(json, polygon, 2);
        }
    }

    private static List<Step> steps(SteppedPolygonClipper method, PolygonInWindow input) {
        Steps.requireAtMost(ClipRun.MOST_STEPPED, "corners", input.subject().length / 2);
        var steps = new ArrayList<Step>();
        PolygonWalk walk = method.walk(input.window(), input.subject());
        while (walk.advance()) steps.add(new Step(walk.at(), walk.polygon()));
        return steps;
    }

    private static void writePieces(JsonGenerator json, List<double[]> pieces) throws IOException {
        json.writeArrayFieldStart("polygons");
        for (double[] piece : pieces) JsonNumbers.writePoints(json, piece, 2);
        json.writeEndArray();
    }
}
