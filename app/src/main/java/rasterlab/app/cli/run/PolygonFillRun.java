package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.engine.polygon.Points;
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
    private static final String DECISION = "how many edges cross the row";
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
    public Form form() {
        return new Form(
                """
                {"polygon":[[x,y],...], "rule":"evenodd" or "nonzero", "size":[w,h]}""",
                """
                {"pixels":[[x,y],...]} row by row""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        PolygonTask task = task(StrictJson.object(text, length, POLYGON, RULE, SIZE));
        PolygonFiller filler = topic.method(method).implementation();
        return watch.call(method, () -> filled(method, filler, task, steps));
    }

    private static PolygonTask task(Given given) {
        Points corners = Points.of(given.get(POLYGON));
        FillRule rule = given.get(RULE).equals("evenodd") ? FillRule.EVEN_ODD : FillRule.NON_ZERO;
        return new PolygonTask(
                corners.xs(), corners.ys(), rule, given.get(SIZE).get(0), given.get(SIZE).get(1));
    }

    private Answer filled(String method, PolygonFiller filler, PolygonTask task, boolean steps) {
        List<Step> walked =
                steps ? steps(Steps.of(method, filler, SteppedPolygon.class), task) : List.of();
        PixelRecording pixels = pixels(filler, task);
        return json -> {
            PixelJson.write(json, pixels);
            if (steps) Steps.write(json, DECISION, walked, (out, step) -> step.write(out));
        };
    }

    private PixelRecording pixels(PolygonFiller filler, PolygonTask task) {
        try {
            return topic.record(filler, task, PixelSink.MOST_PIXELS);
        } catch (LimitReached tooMany) {
            throw PixelSink.tooMany("give a smaller \"size\"");
        }
    }

    private record Step(int y, int from, int to, int crossings) {
        void write(JsonGenerator json) throws IOException {
            json.writeNumberField("y", y);
            json.writeNumberField("from", from);
            json.writeNumberField("to", to);
            json.writeNumberField("decision", crossings);
        }
    }

    private static List<Step> steps(SteppedPolygon filler, PolygonTask task) {
        var steps = new ArrayList<Step>();
        SpanWalk walk = filler.walk(task.x(), task.y(), task.rule(), task.width(), task.height());
        while (walk.advance())
            Steps.add(steps, new Step(walk.y(), walk.from(), walk.to(), walk.crossings()));
        return steps;
    }
}
