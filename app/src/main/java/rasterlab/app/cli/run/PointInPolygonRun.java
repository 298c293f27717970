package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.PointInPolygon;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.inside.EdgeWalk;
import rasterlab.engine.polygon.inside.PointInPolygonTopic;
import rasterlab.engine.polygon.inside.SteppedPolygonTest;
import rasterlab.engine.study.Topic;

/** Topic {@code point-in-polygon}: {@code polygon}, {@code points}; {@code inside} out. */
public final class PointInPolygonRun implements TopicRun {
    /** The most edges looked at whose steps are written. */
    private static final int MOST_STEPS = 1_000_000;

    /** The most edges that all points are compared with: some seconds. */
    private static final int MOST_WORK = 250_000_000;

    private static final JsonField<double[]> POLYGON =
            JsonField.required("polygon", json -> json.points(2, 3, PointJson.MOST));
    private static final JsonField<double[]> POINTS = PointJson.points(2);

    private final Topic<PointInPolygon, ?, ?> topic;
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    PointInPolygonRun(Watch watch) {
        this(watch, new PointInPolygonTopic());
    }

    PointInPolygonRun(Watch watch, Topic<PointInPolygon, ?, ?> topic) {
        this.watch = watch;
        this.topic = topic;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"polygon":[[x,y],...], "points":[[x,y],...]}, corners times points at most 250000000""",
                """
                {"inside":[true,...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, POLYGON, POINTS);
        Points polygon = Points.of(given.get(POLYGON));
        Points points = Points.of(given.get(POINTS));
        long work = (long) polygon.size() * points.size();
        Work.requireAtMost("/points", MOST_WORK, "corners times points", work);
        double[] polygonX = polygon.xs();
        double[] polygonY = polygon.ys();
        PointInPolygon judge = topic.method(method).implementation();
        if (steps) return stepped(method, judge, polygon, points);
        return MembershipAnswer.of(
                watch, method, points, (x, y) -> judge.contains(polygonX, polygonY, x, y));
    }

    /** An edge looked at, with the count after it. */
    private record Step(int edge, int count) {
        void write(JsonGenerator json) throws IOException {
            json.writeNumberField("edge", edge);
            json.writeNumberField("count", count);
            json.writeNumberField("decision", count);
        }
    }

    private Answer stepped(String method, PointInPolygon judge, Points polygon, Points points) {
        SteppedPolygonTest stepped = Steps.of(method, judge, SteppedPolygonTest.class);
        Steps.requireAtMost(
                MOST_STEPS, "corners times points", (long) polygon.size() * points.size());
        double[] polygonX = polygon.xs();
        double[] polygonY = polygon.ys();
        var steps = new ArrayList<List<Step>>();
        return MembershipAnswer.of(
                watch,
                method,
                points,
                (x, y) -> {
                    EdgeWalk walk = stepped.walk(polygonX, polygonY, x, y);
                    steps.add(drained(walk));
                    return walk.inside();
                },
                json ->
                        Steps.writeLists(
                                json,
                                stepped.countFormula(),
                                steps,
                                (out, step) -> step.write(out)));
    }

    private static List<Step> drained(EdgeWalk walk) {
        var steps = new ArrayList<Step>();
        while (walk.advance()) steps.add(new Step(walk.edge(), walk.count()));
        return steps;
    }
}
