package rasterlab.app.cli.run;

import java.time.Duration;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

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
        return switch (topic) {
            case "spline-function" -> new SplineFunctionRun(watch);
            default -> TopicRunner.of(watch, topicNamed(topic));
        };
    }

    private static Topic<?, ?, ?> topicNamed(String topic) {
        try {
            return Topics.named(topic);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    /**
     * Passes if the topic has that method.
     *
     * @throws Complaint listing the methods, if it has not
     */
    public static void requireMethod(TopicRun run, String method) {
        try {
            run.topic().method(method);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }
}
