package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.triangle.PointInTriangleTopic;
import rasterlab.engine.polygon.triangle.SideWalk;
import rasterlab.engine.polygon.triangle.SteppedTriangleTest;
import rasterlab.engine.study.Topic;

/** Topic {@code point-in-triangle}: {@code triangle}, {@code points}; {@code inside} out. */
public final class PointInTriangleRun implements TopicRun {
    /** The most points whose steps one answer has. */
    private static final int MOST_STEPPED = 100_000;

    private static final JsonField<double[]> TRIANGLE =
            JsonField.required("triangle", json -> json.points(2, 3, 3));
    private static final JsonField<double[]> POINTS = PointJson.points(2);

    private final Topic<PointInTriangle, ?, ?> topic;
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    PointInTriangleRun(Watch watch) {
        this(watch, new PointInTriangleTopic());
    }

    PointInTriangleRun(Watch watch, Topic<PointInTriangle, ?, ?> topic) {
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
                {"triangle":[[x,y],[x,y],[x,y]], "points":[[x,y],...]}""",
                """
                {"inside":[true,...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, TRIANGLE, POINTS);
        double[] t = given.get(TRIANGLE);
        Points points = Points.of(given.get(POINTS));
        PointInTriangle triangle = topic.method(method).implementation();
        if (steps) return stepped(method, triangle, t, points);
        return MembershipAnswer.of(
                watch,
                method,
                points,
                (x, y) -> triangle.contains(t[0], t[1], t[2], t[3], t[4], t[5], x, y));
    }

    /** A side asked, with what it said. */
    private record Step(int side, double decision) {
        void write(JsonGenerator json) throws IOException {
            json.writeNumberField("side", side);
            JsonNumbers.writeField(json, "decision", decision);
        }
    }

    private Answer stepped(String method, PointInTriangle triangle, double[] t, Points points) {
        SteppedTriangleTest stepped = Steps.of(method, triangle, SteppedTriangleTest.class);
        Steps.requireAtMost(MOST_STEPPED, "points", points.size());
        var steps = new ArrayList<List<Step>>();
        return MembershipAnswer.of(
                watch,
                method,
                points,
                (x, y) -> {
                    SideWalk walk = stepped.walk(t[0], t[1], t[2], t[3], t[4], t[5], x, y);
                    steps.add(drained(walk));
                    return walk.inside();
                },
                json ->
                        Steps.writeLists(
                                json,
                                stepped.valueFormula(),
                                steps,
                                (out, step) -> step.write(out)));
    }

    private static List<Step> drained(SideWalk walk) {
        var steps = new ArrayList<Step>();
        while (walk.advance()) steps.add(new Step(walk.side(), walk.value()));
        return steps;
    }
}
