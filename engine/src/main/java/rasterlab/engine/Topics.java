package rasterlab.engine;

import java.util.List;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.chain.TransformTopic;
import rasterlab.engine.transform.matrix.MatrixTopic;
import rasterlab.engine.transform.rotate.RotateTopic;
import rasterlab.engine.transform.view.ViewTopic;

/** The list of every topic there is. */
public final class Topics {
    private Topics() {}

    /** All topics, in the course's order. */
    public static List<Topic<?, ?, ?>> all() {
        return List.of(
                new LineTopic(), //
                new MatrixTopic(),
                new TransformTopic(),
                new ViewTopic(),
                new RotateTopic(),
                new AxisTopic());
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
