package rasterlab.app.cli.run;

import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.rotate.Turns;

/** Topic {@code rotate}: {@code points}, {@code degrees}, {@code times}; {@code points} out. */
final class RotateRun implements TopicRun {
    private static final JsonField<double[]> POINTS = PointJson.points(2);
    private static final JsonField<Double> DEGREES =
            JsonField.required("degrees", StrictJson::number);
    private static final JsonField<Integer> TIMES =
            JsonField.optional("times", json -> json.integer(0, PlaneRotation.MOST_TIMES));

    private final Topic<PlaneRotation, Turns, Images> topic = new RotateTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    RotateRun(Watch watch) {
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
                {"points":[[x,y],...], "degrees":a, "times":n}, times being optional""",
                """
                {"points":[[x,y],...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        if (steps) throw Steps.none(method);
        Given given = StrictJson.object(text, length, POINTS, DEGREES, TIMES);
        double[] points = given.get(POINTS);
        PlaneRotation rotation = topic.method(method).implementation();
        watch.call(
                method,
                () -> {
                    rotation.rotate(given.get(DEGREES), given.find(TIMES).orElse(1), points);
                    return points;
                });
        return json -> PointJson.write(json, points, 2);
    }
}
