package rasterlab.app.coordinates.list;

/**
 * A hazard about points of space, and the method that is tried on it.
 *
 * @param topic one of {@link Trials}
 * @param hazard one of the topic's
 * @param method one of the topic's
 */
public record Trial(String topic, String hazard, String method) {
    /** Whether it is the same hazard. */
    boolean isLike(Trial other) {
        return topic.equals(other.topic) && hazard.equals(other.hazard);
    }

    Trial by(String other) {
        return new Trial(topic, hazard, other);
    }
}
