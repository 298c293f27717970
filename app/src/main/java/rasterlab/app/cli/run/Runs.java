package rasterlab.app.cli.run;

import java.time.Duration;
import java.util.List;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.study.Method;

/** The topics that {@code ./lab run} reads and writes. */
public final class Runs {
    private static final Duration LONGEST = Duration.ofSeconds(60);

    private Runs() {}

    /**
     * The topic of that name.
     *
     * @throws Complaint listing the topics, if there is none
     */
    public static TopicRun named(String topic) {
        var watch = new Watch(LONGEST);
        List<TopicRun> all =
                List.of(
                        new LineRun(watch),
                        new CircleRun(watch),
                        new EllipseRun(watch),
                        new FillRun(watch),
                        new PolygonFillRun(watch),
                        new SplineFunctionRun(watch),
                        new CurveRun(watch));
        return all.stream()
                .filter(run -> run.topic().name().equals(topic))
                .findFirst()
                .orElseThrow(
                        () ->
                                Complaint.badInput(
                                        "unknown topic '"
                                                + topic
                                                + "'; allowed are "
                                                + all.stream()
                                                        .map(run -> run.topic().name())
                                                        .toList()));
    }

    /**
     * Passes if the topic has that method.
     *
     * @throws Complaint listing the methods, if it has not
     */
    public static void requireMethod(TopicRun run, String method) {
        List<String> methods = run.topic().methods().stream().map(Method::name).toList();
        if (!methods.contains(method))
            throw Complaint.badInput(
                    "topic '"
                            + run.topic().name()
                            + "' has no method '"
                            + method
                            + "'; allowed are "
                            + methods);
    }
}
