package rasterlab.app.cli.run;

import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.engine.circle.Ellipse;
import rasterlab.engine.circle.EllipseTopic;
import rasterlab.engine.circle.SteppedEllipse;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Topic;

/** Topic {@code ellipse}: {@code center}, {@code rx}, {@code ry}; {@code pixels} out. */
final class EllipseRun implements TopicRun {
    private static final JsonField<int[]> CENTER =
            JsonField.required("center", json -> json.integers(2));
    private static final JsonField<Integer> RX = JsonField.required("rx", StrictJson::integer);
    private static final JsonField<Integer> RY = JsonField.required("ry", StrictJson::integer);

    private final EllipseTopic topic = new EllipseTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    EllipseRun(Watch watch) {
        this.watch = watch;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, CENTER, RX, RY);
        int[] center = given.get(CENTER);
        var input = new Ellipse(center[0], center[1], given.get(RX), given.get(RY));
        EllipseRasterizer implementation = topic.method(method).implementation();
        return watch.call(method, () -> draw(method, implementation, input, steps));
    }

    private static Answer draw(
            String method, EllipseRasterizer implementation, Ellipse c, boolean steps) {
        var sink =
                new LineSink(
                        method,
                        PixelWindow.EVERYTHING,
                        8L * ((long) c.radiusX() + c.radiusY()) + 8);
        implementation.draw(c.centreX(), c.centreY(), c.radiusX(), c.radiusY(), sink);
        if (!steps) return ArcAnswer.of(sink.kept());
        if (!(implementation instanceof SteppedEllipse stepped))
            throw Complaint.badInput("--steps: method '" + method + "' has no steps");
        return ArcAnswer.of(
                sink.kept(), stepped.decisionFormula(), stepped.walk(c.radiusX(), c.radiusY()));
    }
}
