package rasterlab.app.cli.study;

import java.util.List;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

/** The topics that a command's TOPIC argument names. */
final class TopicChoice {
    private TopicChoice() {}

    /**
     * @param topic a topic's name, or null for all
     * @throws Complaint listing the topics, if there is none of that name
     */
    static List<? extends Topic<?, ?, ?>> of(String topic) {
        return topic == null ? Topics.all() : List.of(one(topic));
    }

    static Topic<?, ?, ?> one(String topic) {
        try {
            return Topics.named(topic);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }
}
