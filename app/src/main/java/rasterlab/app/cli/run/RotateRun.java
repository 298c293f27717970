package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Doubles;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.rotate.SteppedRotation;
import rasterlab.engine.transform.rotate.TurnWalk;
import rasterlab.engine.transform.rotate.Turns;

/** Topic {@code rotate}: {@code points}, {@code degrees}, {@code times}; {@code points} out. */
final class RotateRun implements TopicRun {
    /** The most turns, those of all points together, whose steps one answer has. */
    private static final int MOST_TURNS = 100_000;

    /** The most turns of all points together: some seconds. */
    private static final int MOST_WORK = 500_000_000;

    private static final JsonField<double[]> POINTS = PointJson.points(2);
    private static final JsonField<Double> DEGREES =
            JsonField.required("degrees", StrictJson::number);
    private static final JsonField<Integer> TIMES =
            JsonField.optional("times", json -> json.integer(0, PlaneRotation.MOST_TIMES));

    private final Topic<PlaneRotation, Turns, Images> topic;
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    RotateRun(Watch watch) {
        this(watch, new RotateTopic());
    }

    RotateRun(Watch watch, Topic<PlaneRotation, Turns, Images> topic) {
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
                {"points":[[x,y],...], "degrees":a, "times":n}, times being optional; points \
                times turns at most 500000000""",
                """
                {"points":[[x,y],...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, POINTS, DEGREES, TIMES);
        double[] points = given.get(POINTS);
        PlaneRotation rotation = topic.method(method).implementation();
        int times = given.find(TIMES).orElse(1);
        Work.requireAtMost("/times", MOST_WORK, "points times turns", points.length / 2L * times);
        if (steps) return stepped(method, rotation, given);
        watch.call(
                method,
                () -> {
                    rotation.rotate(given.get(DEGREES), times, points);
                    return points;
                });
        return json -> PointJson.write(json, points, 2);
    }

    /** One formula of one turn, what it gave, and where the point was then. */
    private record Step(int turn, String text, double value, double x, double y) {
        void write(JsonGenerator json) throws IOException {
            json.writeNumberField("turn", turn);
            json.writeStringField("step", text);
            JsonNumbers.writeField(json, "value", value);
            json.writeFieldName("point");
            JsonNumbers.write(json, new double[] {x, y});
        }
    }

    private Answer stepped(String method, PlaneRotation rotation, Given given) {
        SteppedRotation stepped = Steps.of(method, rotation, SteppedRotation.class);
        double[] points = given.get(POINTS);
        int times = given.find(TIMES).orElse(1);
        Steps.requireAtMost(MOST_TURNS, "points times turns", points.length / 2L * times);
        var steps = new ArrayList<List<Step>>();
        double[] turned =
                watch.call(
                        method,
                        () -> {
                            var left = new Doubles();
                            for (int i = 0; i < points.length; i += 2)
                                steps.add(
                                        drained(
                                                stepped.walk(
                                                        given.get(DEGREES),
                                                        times,
                                                        points[i],
                                                        points[i + 1]),
                                                left));
                            return left.toArray();
                        });
        return json -> {
            PointJson.write(json, turned, 2);
            Steps.writeLists(json, steps, (out, step) -> step.write(out));
        };
    }

    private static List<Step> drained(TurnWalk walk, Doubles left) {
        var steps = new ArrayList<Step>();
        while (walk.advance())
            steps.add(new Step(walk.turn(), walk.text(), walk.value(), walk.x(), walk.y()));
        left.add(walk.x());
        left.add(walk.y());
        return steps;
    }
}
