package rasterlab.exercises.judging;

import static java.util.stream.Collectors.joining;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import rasterlab.exercises.score.Message;

/** The values by which a method says yes or no to one of several points or faces. */
final class TruthDecision {
    static final Map<String, Decision> BY_TOPIC =
            Map.of(
                    "point-in-triangle", listed("point-in-triangle"),
                    "point-in-polygon", listed("point-in-polygon"),
                    "visible-faces", listed("visible-faces"));

    private TruthDecision() {}

    private static Decision listed(String topic) {
        return (input, right, at) ->
                at.index().isPresent()
                        ? on(topic, input, right, at.index().getAsInt())
                        : Message.NONE;
    }

    /**
     * The sentence on one of them.
     *
     * @param index of it, from 0
     */
    static Message on(String topic, JsonNode input, JsonNode right, int index) {
        String method = topic.equals("visible-faces") ? "back-face" : "robust";
        List<List<JsonNode>> walks = Walk.each(topic, method, input.toString());
        if (topic.equals("visible-faces"))
            return face(walks.get(0).get(index), right.path("visible").path(index).asBoolean());
        boolean inside = right.path("inside").path(index).asBoolean();
        return topic.equals("point-in-triangle")
                ? triangle(walks.get(index), inside)
                : polygon(walks.get(index), inside);
    }

    private static Message face(JsonNode step, boolean visible) {
        double value = step.path("decision").asDouble();
        if (value > 0 != visible) return Message.NONE;
        return Decisions.message(
                "visible-faces",
                visible ? "visible" : "hidden",
                Decisions.number(step.path("decision")));
    }

    private static Message triangle(List<JsonNode> sides, boolean inside) {
        String signs =
                sides.stream()
                        .map(one -> Decisions.number(one.path("decision")))
                        .collect(joining(", ", "(", ")"));
        boolean flat = sides.stream().allMatch(one -> one.path("decision").asDouble() == 0);
        String key = inside ? "inside" : flat ? "flat" : "outside";
        return Decisions.message("point-in-triangle", key, signs);
    }

    private static Message polygon(List<JsonNode> edges, boolean inside) {
        if (edges.isEmpty()) return Message.NONE;
        JsonNode last = edges.get(edges.size() - 1);
        int count = last.path("count").asInt();
        if (inside == (count % 2 == 1))
            return Decisions.message("point-in-polygon", inside ? "inside" : "outside", count);
        return inside
                ? Decisions.message("point-in-polygon", "border", last.path("edge").asInt() + 1)
                : Message.NONE;
    }
}
