package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import java.util.stream.StreamSupport;
import rasterlab.engine.raster.Pixel;
import rasterlab.exercises.score.Message;

/** The comparison of depths that leaves a pixel to the triangle which is seen there. */
final class DepthDecision {
    private static final String TOPIC = "depth-triangle";

    static final Map<String, Decision> BY_TOPIC =
            Map.of("depth-triangle", Decision.onPixel(DepthDecision::on));

    private DepthDecision() {}

    static Message on(JsonNode input, JsonNode right, Pixel at) {
        List<JsonNode> steps =
                Walk.of(TOPIC, "rows", input.toString()).steps().stream()
                        .filter(one -> one.path("x").asInt() == at.x())
                        .filter(one -> one.path("y").asInt() == at.y())
                        .toList();
        if (steps.isEmpty()) return Decisions.message(TOPIC, "uncovered", at);
        int shown = shown(right, at);
        return steps.stream()
                .filter(one -> one.path("triangle").asInt() == shown)
                .findFirst()
                .map(one -> message("written", one, at))
                .orElseGet(() -> message("kept", steps.get(steps.size() - 1), at));
    }

    /** The triangle that the right answer shows there; 0 where it shows none. */
    private static int shown(JsonNode right, Pixel at) {
        return StreamSupport.stream(right.path("pixels").spliterator(), false)
                .filter(one -> one.path(0).asInt() == at.x() && one.path(1).asInt() == at.y())
                .mapToInt(one -> one.path(2).asInt())
                .findFirst()
                .orElse(0);
    }

    private static Message message(String key, JsonNode step, Pixel at) {
        return Decisions.message(
                TOPIC,
                key,
                at,
                step.path("triangle").asInt(),
                Decisions.number(step.path("depth")),
                Decisions.number(step.path("stored")),
                Decisions.number(step.path("decision")));
    }
}
