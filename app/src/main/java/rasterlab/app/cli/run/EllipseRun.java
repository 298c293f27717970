package rasterlab.app.cli.run;

import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.engine.circle.Ellipse;
import rasterlab.engine.circle.EllipseTopic;
import rasterlab.engine.circle.MidpointEllipse;
import rasterlab.engine.circle.SteppedEllipse;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Topic;

/** Topic {@code ellipse}: {@code center}, {@code rx}, {@code ry}; {@code pixels} out. */
final class EllipseRun implements TopicRun {
    private static final JsonField<int[]> CENTER =
            JsonField.required("center", json -> json.integers(2));
    private static final JsonField<Integer> RX = radius("rx");
    private static final JsonField<Integer> RY = radius("ry");
    private static final PixelSink.Figure FIGURE =
            new PixelSink.Figure("ellipse", "give smaller \"rx\" and \"ry\"");

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
    public Form form() {
        return new Form(
                """
                {"center":[x,y], "rx":a, "ry":b}""",
                """
                {"pixels":[[x,y],...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, CENTER, RX, RY);
        int[] center = given.get(CENTER);
        var input = new Ellipse(center[0], center[1], given.get(RX), given.get(RY));
        EllipseRasterizer implementation = topic.method(method).implementation();
        return watch.call(method, () -> draw(method, implementation, input, steps));
    }

    /** In the range that every method takes. */
    private static JsonField<Integer> radius(String name) {
        return JsonField.required(name, json -> json.integer(0, MidpointEllipse.LARGEST));
    }

    private Answer draw(String method, EllipseRasterizer implementation, Ellipse c, boolean steps) {
        var sink =
                new PixelSink(
                        method,
                        FIGURE,
                        PixelWindow.EVERYTHING,
                        topic.mostBeforeEndless(8L * ((long) c.radiusX() + c.radiusY()) + 8));
        implementation.draw(c.centreX(), c.centreY(), c.radiusX(), c.radiusY(), sink);
        if (!steps) return ArcAnswer.of(sink.kept());
        SteppedEllipse stepped = Steps.of(method, implementation, SteppedEllipse.class);
        return ArcAnswer.of(
                sink.kept(), stepped.decisionFormula(), stepped.walk(c.radiusX(), c.radiusY()));
    }
}
