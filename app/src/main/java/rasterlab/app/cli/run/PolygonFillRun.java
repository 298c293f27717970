package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.engine.polygon.scan.PolygonFillTopic;
import rasterlab.engine.polygon.scan.PolygonTask;
import rasterlab.engine.polygon.scan.SpanWalk;
import rasterlab.engine.polygon.scan.SteppedPolygon;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Topic;

/** Topic {@code polygon-fill}: {@code polygon}, {@code rule}, {@code size}; {@code pixels} out. */
final class PolygonFillRun implements TopicRun {
    private static final int MOST_CORNERS = 1_000_000;
    private static final int MOST_PIXELS = 10_000_000;
    private static final JsonField<double[]> POLYGON =
            JsonField.required("polygon", json -> json.points(2, 0, MOST_CORNERS));
    private static final JsonField<String> RULE =
            JsonField.required("rule", json -> json.word(List.of("evenodd", "nonzero")));
    private static final JsonField<List<Integer>> SIZE =
            JsonField.required(
                    "size",
                    json ->
                            json.list(
                                    "whole numbers",
                                    side -> side.integer(1, Raster.LARGEST_SIDE),
                                    2,
                                    2));

    private final PolygonFillTopic topic = new PolygonFillTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    PolygonFillRun(Watch watch) {
        this.watch = watch;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        PolygonTask task = task(StrictJson.object(text, length, POLYGON, RULE, SIZE));
        PolygonFiller filler = topic.method(method).implementation();
        if (steps && !(filler instanceof SteppedPolygon))
            throw Complaint.badInput("--steps: method '" + method + "' has no steps");
        return watch.call(method, () -> filled(filler, task, steps));
    }

    private static PolygonTask task(Given given) {
        double[] corners = given.get(POLYGON);
        var x = new double[corners.length / 2];
        var y = new double[corners.length / 2];
        Arrays.setAll(x, i -> corners[2 * i]);
        Arrays.setAll(y, i -> corners[2 * i + 1]);
        FillRule rule = given.get(RULE).equals("evenodd") ? FillRule.EVEN_ODD : FillRule.NON_ZERO;
        return new PolygonTask(x, y, rule, given.get(SIZE).get(0), given.get(SIZE).get(1));
    }

    private Answer filled(PolygonFiller filler, PolygonTask task, boolean steps) {
        PixelRecording pixels = pixels(filler, task);
        List<Step> walked = steps ? steps((SteppedPolygon) filler, task) : List.of();
        return json -> {
            json.writeArrayFieldStart("pixels");
            for (int i = 0; i < pixels.size(); i++) {
                json.writeStartArray();
                json.writeNumber(pixels.x(i));
                json.writeNumber(pixels.y(i));
                json.writeEndArray();
            }
            json.writeEndArray();
            if (steps) writeSteps(json, walked);
        };
    }

    private PixelRecording pixels(PolygonFiller filler, PolygonTask task) {
        try {
            return topic.record(filler, task, MOST_PIXELS);
        } catch (LimitReached tooMany) {
            throw Complaint.gaveUp(
                    "the answer has more than "
                            + MOST_PIXELS
                            + " pixels, the most that one answer may have; give a smaller \"size\"");
        }
    }

    private record Step(int y, int from, int to, int crossings) {}

    private static List<Step> steps(SteppedPolygon filler, PolygonTask task) {
        var steps = new ArrayList<Step>();
        SpanWalk walk = filler.walk(task.x(), task.y(), task.rule(), task.width(), task.height());
        while (walk.advance())
            steps.add(new Step(walk.y(), walk.from(), walk.to(), walk.crossings()));
        return steps;
    }

    private static void writeSteps(JsonGenerator json, List<Step> steps) throws IOException {
        json.writeStringField("decision", "how many edges cross the row");
        json.writeArrayFieldStart("steps");
        for (Step step : steps) {
            json.writeStartObject();
            json.writeNumberField("y", step.y);
            json.writeNumberField("from", step.from);
            json.writeNumberField("to", step.to);
            json.writeNumberField("decision", step.crossings);
            json.writeEndObject();
        }
        json.writeEndArray();
    }
}
