package rasterlab.exercises.property;

import java.util.function.Predicate;
import rasterlab.exercises.score.Message;

/**
 * A relation that the answers of every right method of a topic keep.
 *
 * @param topic the engine's name of the topic
 * @param name lower-case with hyphens; texts {@code property.TOPIC.NAME} and {@code
 *     property.TOPIC.NAME.assumes} say what it is and by which rule of the topic it holds
 * @param assumed whether that rule decides the answer to an input, so that the relation holds
 * @param relation between the answers
 */
public record Property<I, O>(
        String topic, String name, Predicate<I> assumed, Relation<I, O> relation) {
    /** A property that holds for every input. */
    public static <I, O> Property<I, O> always(String topic, String name, Relation<I, O> relation) {
        return new Property<>(topic, name, any -> true, relation);
    }

    /** Says that it is broken. */
    public Message broken() {
        return Message.of("property.broken", key());
    }

    /**
     * Says that it holds.
     *
     * @param tries number of inputs that were tried
     */
    public Message held(int tries) {
        return Message.of("property.held", tries, key());
    }

    /** The rule that it assumes. */
    public Message rule() {
        return Message.of("property.assumes", key() + ".assumes");
    }

    private String key() {
        return "property." + topic + "." + name;
    }
}
