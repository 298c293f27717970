package rasterlab.exercises.topic;

import static java.util.stream.Collectors.joining;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Kind;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.score.Message;

/**
 * Tells what inputs a case has by its own data: the difficulty that a hazard is made for, the
 * property that is tried, the ranges from which they are drawn, or the first of those given.
 */
final class CaseInputs {
    /** Characters of an input or a template that are told. */
    private static final int MOST = 140;

    private CaseInputs() {}

    /**
     * The sentence on a case's inputs.
     *
     * @param topic whose inputs they are
     */
    static Message of(String topic, Case one) {
        JsonNode data = json(one.input());
        String property = one.property().map(name -> "property." + topic + "." + name).orElse("");
        if (Message.isKnown(property))
            return Message.of("why.property", data.path("count").asInt(), property);
        String hazard = "hazard." + topic + "." + data.path("hazard").asText();
        if (Message.isKnown(hazard)) return Message.of("why.hazard", hazard);
        JsonNode given = data.path("given");
        if (one.generated()) {
            JsonNode turn = given.isArray() ? given.path(0) : given;
            String drawn =
                    Stream.of(data.path("let"), turn)
                            .map(CaseInputs::fields)
                            .filter(told -> !told.isEmpty())
                            .collect(joining("; "));
            return Message.of("why.drawn", data.path("count").asInt(), cut(drawn));
        }
        boolean several = given.isArray();
        return Message.of(
                one.kind() == Kind.STABILITY ? "why.rare" : "why.fixed",
                several ? given.size() : 1,
                cut(fields(several ? given.path(0) : given)));
    }

    private static JsonNode json(String text) {
        try {
            return OwnJson.MAPPER.readTree(text);
        } catch (JsonProcessingException e) {
            throw new AssertionError("a case's input was read before", e);
        }
    }

    /** The fields of an input, without the brackets around. */
    private static String fields(JsonNode input) {
        return input.properties().stream()
                .map(one -> one.getKey() + ": " + value(one.getValue()))
                .collect(joining("; "));
    }

    /** A value, a range such as 0..9, several of one, or what may stand there. */
    private static String value(JsonNode value) {
        if (value.has("times"))
            return value.path("times").asText() + " × " + value(value.path("of"));
        if (value.has("any")) return list(value.path("any"), " | ");
        if (value.isArray()) return "[" + list(value, ", ") + "]";
        return value.isObject() ? fields(value) : value.asText();
    }

    private static String list(JsonNode values, String between) {
        return StreamSupport.stream(values.spliterator(), false)
                .map(CaseInputs::value)
                .collect(joining(between));
    }

    private static String cut(String text) {
        return text.length() <= MOST ? text : text.substring(0, MOST) + "…";
    }
}
