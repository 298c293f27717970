package rasterlab.app.cli.run;

import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.EyeView;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.Coordinates;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.view.Look;
import rasterlab.engine.transform.view.ViewTopic;

/**
 * Topic {@code view}: {@code points}, {@code theta}, {@code phi}, {@code rho}; {@code points} in
 * the left-handed eye space out.
 */
final class ViewRun implements TopicRun {
    private static final JsonField<double[]> POINTS = PointJson.points(3);
    private static final JsonField<Double> THETA = JsonField.required("theta", StrictJson::number);
    private static final JsonField<Double> PHI = JsonField.required("phi", StrictJson::number);
    private static final JsonField<Double> RHO =
            JsonField.required("rho", json -> json.numberAbove(0, Coordinates.LARGEST));

    private final Topic<EyeView, Look, Images> topic = new ViewTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    ViewRun(Watch watch) {
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
                {"points":[[x,y,z],...], "theta":a, "phi":b, "rho":r}""",
                """
                {"points":[[x,y,z],...]} in the left-handed space of the eye""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        if (steps) throw Steps.none(method);
        Given given = StrictJson.object(text, length, POINTS, THETA, PHI, RHO);
        var look = new Look(given.get(THETA), given.get(PHI), given.get(RHO), given.get(POINTS));
        EyeView view = topic.method(method).implementation();
        Images images = watch.call(method, () -> topic.record(view, look, Integer.MAX_VALUE));
        return json -> PointJson.write(json, images.coordinates(), 3);
    }
}
