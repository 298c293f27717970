package rasterlab.exercises.judging;

import static java.util.stream.Collectors.toUnmodifiableMap;

import com.fasterxml.jackson.databind.JsonNode;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.exercises.score.Message;

/**
 * Says by which value of its recorded walk a right method decides on the first item in which an
 * answer differs. Nothing is said where the topic's methods decide nothing, as those that compute
 * numbers, or where the walk has no such step.
 */
final class Decisions {
    private static final MathContext TOLD = new MathContext(7);

    private static final Map<String, Decision> BY_TOPIC =
            Stream.of(
                            LineDecision.BY_TOPIC,
                            ArcDecision.BY_TOPIC,
                            ClipDecision.BY_TOPIC,
                            AreaDecision.BY_TOPIC,
                            DepthDecision.BY_TOPIC,
                            TruthDecision.BY_TOPIC)
                    .flatMap(one -> one.entrySet().stream())
                    .collect(toUnmodifiableMap(Map.Entry::getKey, Map.Entry::getValue));

    private Decisions() {}

    /**
     * The sentence on that item.
     *
     * @param input a JSON object, as {@code ./lab run} takes it
     * @param right the right answer to it
     */
    static Message of(String topic, JsonNode input, JsonNode right, DifferingItem at) {
        Decision decision = BY_TOPIC.get(topic);
        if (decision == null) return Message.NONE;
        try {
            return decision.on(input, right, at);
        } catch (IllegalArgumentException refused) {
            return Message.NONE;
        }
    }

    /** The sentence of that key in the topic's words. */
    static Message message(String topic, String key, Object... arguments) {
        return Message.of("decided." + topic + "." + key, arguments);
    }

    /** A value as people are told it, with the few digits that they need. */
    static String number(JsonNode value) {
        return number(value.decimalValue());
    }

    static String number(BigDecimal value) {
        BigDecimal rounded = value.round(TOLD).stripTrailingZeros();
        return rounded.signum() == 0 ? "0" : rounded.toPlainString();
    }
}
