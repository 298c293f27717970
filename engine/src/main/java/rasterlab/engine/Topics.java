package rasterlab.engine;

import java.util.List;
import rasterlab.engine.circle.CircleTopic;
import rasterlab.engine.circle.EllipseTopic;
import rasterlab.engine.fill.FillTopic;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.polygon.scan.PolygonFillTopic;
import rasterlab.engine.spline.CurveTopic;
import rasterlab.engine.spline.SplineFunctionTopic;
import rasterlab.engine.study.Topic;

/** The list of every topic there is. */
public final class Topics {
    private Topics() {}

    /** All topics, in the course's order. */
    public static List<Topic<?, ?, ?>> all() {
        return List.of(
                new LineTopic(),
                new CircleTopic(),
                new EllipseTopic(),
                new FillTopic(),
                new PolygonFillTopic(),
                new SplineFunctionTopic(),
                new CurveTopic());
    }

    /**
     * The topic of that name.
     *
     * @throws IllegalArgumentException if there is none; lists those there are
     */
    public static Topic<?, ?, ?> named(String name) {
        return all().stream()
                .filter(topic -> topic.name().equals(name))
                .findFirst()
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "no topic '"
                                                + name
                                                + "'; there are "
                                                + all().stream().map(Topic::name).toList()));
    }
}
