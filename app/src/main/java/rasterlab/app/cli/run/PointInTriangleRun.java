package rasterlab.app.cli.run;

import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.triangle.PointInTriangleTopic;
import rasterlab.engine.study.Topic;

/** Topic {@code point-in-triangle}: {@code triangle}, {@code points}; {@code inside} out. */
public final class PointInTriangleRun implements TopicRun {
    private static final JsonField<double[]> TRIANGLE =
            JsonField.required("triangle", json -> json.points(2, 3, 3));
    private static final JsonField<double[]> POINTS = PointJson.points(2);

    private final PointInTriangleTopic topic = new PointInTriangleTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    PointInTriangleRun(Watch watch) {
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
                {"triangle":[[x,y],[x,y],[x,y]], "points":[[x,y],...]}""",
                """
                {"inside":[true,...]}""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, TRIANGLE, POINTS);
        if (steps) throw Steps.none(method);
        double[] t = given.get(TRIANGLE);
        Points points = Points.of(given.get(POINTS));
        PointInTriangle triangle = topic.method(method).implementation();
        Membership inside =
                watch.call(
                        method,
                        () ->
                                new Membership(
                                        points,
                                        points.size(),
                                        (x, y) ->
                                                triangle.contains(
                                                        t[0], t[1], t[2], t[3], t[4], t[5], x, y)));
        return json -> InsideJson.write(json, inside);
    }
}
