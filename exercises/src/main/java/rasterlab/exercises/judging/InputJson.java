package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.util.List;
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

    /**
     * The inputs that make up a hazard, as {@code ./lab run} takes them, without those that have
     * what is not told outside.
     */
    public static List<JsonNode> singles(Topic<?, ?, ?> topic, String hazard) {
        return hazardInputs(topic, hazard);
    }

    /** Whether a hazard can be told as one such input. */
    public static boolean isWhole(Topic<?, ?, ?> topic, String hazard) {
        return isWrittenAsOne(topic, hazard);
    }

    private static <C, I> boolean isWrittenAsOne(Topic<C, I, ?> topic, String hazard) {
        return !written(topic.format(), input(topic, hazard)).isMissingNode();
    }

    private static <C, I> List<JsonNode> hazardInputs(Topic<C, I, ?> topic, String hazard) {
        return topic.format().singles(input(topic, hazard)).stream()
                .map(one -> written(topic.format(), one))
                .filter(one -> !one.isMissingNode())
                .toList();
    }

    /**
     * The hazard's input as {@code ./lab run} takes it; missing where it has what is not told
     * outside.
     */
    public static JsonNode of(Topic<?, ?, ?> topic, String hazard) {
        return written(topic, hazard);
    }

    private static <C, I> JsonNode written(Topic<C, I, ?> topic, String hazard) {
        return written(topic.format(), topic.format().singles(input(topic, hazard)).get(0));
    }

    private static <I> I input(Topic<?, I, ?> topic, String hazard) {
        return topic.hazards().stream()
                .filter(one -> one.name().equals(hazard))
                .findFirst()
                .orElseThrow()
                .input();
    }

    private static <C, I> JsonNode written(Format<C, I, ?> format, I input) {
        try {
            return Leaves.tree(format, input);
        } catch (IllegalArgumentException untold) {
            return MissingNode.getInstance();
        }
    }
}
