package rasterlab.app.card;

/**
 * An input of a topic that a tab is to show.
 *
 * @param hazard its name; "" for an input that has none
 * @param input of the topic's own type
 */
public record TopicInput(String topic, String hazard, Object input) {
    /** The scene's name, which is unlike every lab scene's. */
    public String name() {
        return hazard.isEmpty() ? topic + "-input" : topic + "-" + hazard;
    }
}
