package rasterlab.app.cli.run;

import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.CircleRasterizer;
import rasterlab.engine.circle.Circle;
import rasterlab.engine.circle.CircleTopic;
import rasterlab.engine.circle.SteppedCircle;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Topic;

/** Topic {@code circle}: {@code center}, {@code radius}; {@code pixels} out. */
final class CircleRun implements TopicRun {
    private static final JsonField<int[]> CENTER =
            JsonField.required("center", json -> json.integers(2));
    private static final JsonField<Integer> RADIUS =
            JsonField.required("radius", json -> json.integer(0, Integer.MAX_VALUE));
    private static final PixelSink.Figure FIGURE =
            new PixelSink.Figure("circle", "give a smaller \"radius\"");

    private final CircleTopic topic = new CircleTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    CircleRun(Watch watch) {
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
                {"center":[x,y], "radius":r}""",
                """
                {"pixels":[[x,y],...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, CENTER, RADIUS);
        int[] center = given.get(CENTER);
        var input = new Circle(center[0], center[1], given.get(RADIUS));
        CircleRasterizer implementation = topic.method(method).implementation();
        return watch.call(method, () -> draw(method, implementation, input, steps));
    }

    private Answer draw(String method, CircleRasterizer implementation, Circle c, boolean steps) {
        var sink =
                new PixelSink(
                        method,
                        FIGURE,
                        PixelWindow.EVERYTHING,
                        topic.mostBeforeEndless(8L * c.radius() + 8));
        implementation.draw(c.centreX(), c.centreY(), c.radius(), sink);
        if (!steps) return ArcAnswer.of(sink.kept());
        SteppedCircle stepped = Steps.of(method, implementation, SteppedCircle.class);
        return ArcAnswer.of(sink.kept(), stepped.decisionFormula(), stepped.walk(c.radius()));
    }
}
