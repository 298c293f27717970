package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.axis.AxisTurn;
import rasterlab.engine.transform.axis.SteppedAxisRotation;

/**
 * Topic {@code rotate-axis}: {@code points}, {@code through}, {@code direction}, {@code degrees};
 * {@code points} out.
 */
final class AxisRun implements TopicRun {
    private static final JsonField<double[]> POINTS = PointJson.points(3);
    private static final JsonField<double[]> THROUGH =
            JsonField.required("through", json -> json.numbers(3, 3));
    private static final JsonField<double[]> DIRECTION =
            JsonField.required("direction", json -> json.numbers(3, 3));
    private static final JsonField<Double> DEGREES =
            JsonField.required("degrees", StrictJson::number);

    /** The most points whose steps one answer has. */
    private static final int MOST_STEPPED = 1_000_000;

    private final Topic<AxisRotation, AxisTurn, Images> topic = new AxisTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    AxisRun(Watch watch) {
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
                {"points":[[x,y,z],...], "through":[x,y,z], "direction":[l,m,n], \
                "degrees":a}""",
                """
                {"points":[[x,y,z],...]}""");
    }

    /** What one step did and where it left the points. */
    private record Step(String text, double[] points) {}

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, POINTS, THROUGH, DIRECTION, DEGREES);
        AxisRotation rotation = topic.method(method).implementation();
        if (steps) return stepped(method, rotation, given);
        double[] points = given.get(POINTS);
        watch.call(
                method,
                () -> {
                    rotation.rotate(
                            given.get(THROUGH), given.get(DIRECTION), given.get(DEGREES), points);
                    return points;
                });
        return json -> PointJson.write(json, points, 3);
    }

    private Answer stepped(String method, AxisRotation rotation, Given given) {
        SteppedAxisRotation stepped = Steps.of(method, rotation, SteppedAxisRotation.class);
        Steps.requireAtMost(MOST_STEPPED, "points", given.get(POINTS).length / 3);
        List<Step> steps = watch.call(method, () -> steps(stepped, given));
        return json -> {
            PointJson.write(json, steps.get(steps.size() - 1).points(), 3);
            writeSteps(json, steps);
        };
    }

    private static List<Step> steps(SteppedAxisRotation rotation, Given given) {
        var walk =
                rotation.walk(
                        given.get(THROUGH),
                        given.get(DIRECTION),
                        given.get(DEGREES),
                        given.get(POINTS));
        var steps = new ArrayList<Step>();
        while (walk.advance()) steps.add(new Step(walk.text(), walk.points()));
        return steps;
    }

    private static void writeSteps(JsonGenerator json, List<Step> steps) throws IOException {
        json.writeArrayFieldStart("steps");
        for (Step step : steps) {
            json.writeStartObject();
            json.writeStringField("step", step.text());
            PointJson.write(json, step.points(), 3);
            json.writeEndObject();
        }
        json.writeEndArray();
    }
}
