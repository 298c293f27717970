package rasterlab.app.shell;

/**
 * An input of a topic that a tab is to show.
 *
 * @param hazard its name; "" for an input that has none
 * @param input of the topic's own type
 */
record TopicInput(String topic, String hazard, Object input) {
    /** Unlike every lab scene's name. */
    String name() {
        return hazard.isEmpty() ? topic + "-input" : topic + "-" + hazard;
    }
}
