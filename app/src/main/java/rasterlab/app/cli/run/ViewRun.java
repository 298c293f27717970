package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.EyeView;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Coordinates;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.view.Look;
import rasterlab.engine.transform.view.SteppedView;
import rasterlab.engine.transform.view.ViewStep;
import rasterlab.engine.transform.view.ViewTopic;

/**
 * Topic {@code view}: {@code points}, {@code theta}, {@code phi}, {@code rho}; {@code points} in
 * the left-handed eye space out.
 */
final class ViewRun implements TopicRun {
    /** The most points whose steps one answer has. */
    private static final int MOST_STEPPED = 100_000;

    private static final JsonField<double[]> POINTS = PointJson.points(3);
    private static final JsonField<Double> THETA = JsonField.required("theta", StrictJson::number);
    private static final JsonField<Double> PHI = JsonField.required("phi", StrictJson::number);
    private static final JsonField<Double> RHO =
            JsonField.required("rho", json -> json.numberAbove(0, Coordinates.LARGEST));

    private final Topic<EyeView, Look, Images> topic;
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    ViewRun(Watch watch) {
        this(watch, new ViewTopic());
    }

    ViewRun(Watch watch, Topic<EyeView, Look, Images> topic) {
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
                {"points":[[x,y,z],...], "theta":a, "phi":b, "rho":r}""",
                """
                {"points":[[x,y,z],...]} in the left-handed space of the eye""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, POINTS, THETA, PHI, RHO);
        var look = new Look(given.get(THETA), given.get(PHI), given.get(RHO), given.get(POINTS));
        EyeView view = topic.method(method).implementation();
        if (steps) return stepped(method, view, look);
        Images images = watch.call(method, () -> topic.record(view, look, Integer.MAX_VALUE));
        return json -> PointJson.write(json, images.coordinates(), 3);
    }

    private Answer stepped(String method, EyeView view, Look look) {
        SteppedView stepped = Steps.of(method, view, SteppedView.class);
        Steps.requireAtMost(MOST_STEPPED, "points", look.points().length / 3);
        var steps = new ArrayList<List<ViewStep>>();
        Images images =
                watch.call(
                        method,
                        () -> {
                            double[] p = look.points();
                            for (int i = 0; i < p.length; i += 3)
                                steps.add(
                                        stepped.steps(
                                                look.theta(),
                                                look.phi(),
                                                look.rho(),
                                                p[i],
                                                p[i + 1],
                                                p[i + 2]));
                            return topic.record(view, look, Integer.MAX_VALUE);
                        });
        return json -> {
            PointJson.write(json, images.coordinates(), 3);
            Steps.writeLists(json, steps, ViewRun::write);
        };
    }

    private static void write(JsonGenerator json, ViewStep step) throws IOException {
        json.writeNumberField("number", step.number());
        json.writeStringField("step", step.formula());
        JsonNumbers.writeField(json, "value", step.value());
    }
}
