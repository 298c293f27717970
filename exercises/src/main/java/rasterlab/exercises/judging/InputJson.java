package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Topic;

/** Writes the input of a topic's hazard as data. */
public final class InputJson {
    private InputJson() {}

    /**
     * An input as {@code ./lab run} takes it.
     *
     * @param input one of the format's singles
     * @throws IllegalArgumentException if it has what is not told outside
     */
    public static <C, I> String of(Format<C, I, ?> format, I input) {
        return Leaves.json(format, input);
    }

    /** As {@code ./lab run} takes it; missing where it has what is not told outside. */
    public static JsonNode of(Topic<?, ?, ?> topic, String hazard) {
        return written(topic, hazard);
    }

    private static <C, I> JsonNode written(Topic<C, I, ?> topic, String hazard) {
        I input =
                topic.hazards().stream()
                        .filter(one -> one.name().equals(hazard))
                        .findFirst()
                        .orElseThrow()
                        .input();
        try {
            return Leaves.tree(topic.format(), topic.format().singles(input).get(0));
        } catch (IllegalArgumentException untold) {
            return MissingNode.getInstance();
        }
    }
}
