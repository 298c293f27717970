package rasterlab.exercises.topic;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.score.Message;

/**
 * Tells what inputs a case has by its own data: the difficulty that a hazard is made for, the
 * property that is tried, the ranges from which they are drawn, or the first of those given.
 */
final class CaseInputs {
    /** Characters of an input or a template that are told. */
    private static final int MOST = 140;

    private static final JsonNode NO_NUMBERS = MissingNode.getInstance();

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
            JsonNode turn = given;
            while (turn.isArray()) turn = turn.path(0);
            String drawn = new TemplateText(data.path("let")).of(turn);
            return Message.of("why.drawn", data.path("count").asInt(), cut(drawn));
        }
        boolean several = given.isArray();
        return Message.of(
                one.kind() == Criterion.STABILITY ? "why.rare" : "why.fixed",
                several ? given.size() : 1,
                cut(new TemplateText(NO_NUMBERS).of(several ? given.path(0) : given)));
    }

    private static JsonNode json(String text) {
        try {
            return OwnJson.MAPPER.readTree(text);
        } catch (JsonProcessingException e) {
            throw new AssertionError("a case's input was read before", e);
        }
    }

    private static String cut(String text) {
        return text.length() <= MOST ? text : text.substring(0, MOST) + "…";
    }
}
