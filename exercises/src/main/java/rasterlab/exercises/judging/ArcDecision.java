package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.raster.Pixel;
import rasterlab.exercises.score.Message;

/** The value of the midpoint method in the octant of a circle, or the quarter of an ellipse. */
final class ArcDecision {
    /** The walk of a larger one takes longer than the rest of a report. */
    private static final int LARGEST = 100_000;

    static final Map<String, Decision> BY_TOPIC =
            Map.of(
                    "circle", Decision.onPixel((input, right, one) -> onCircle(input, one)),
                    "ellipse", Decision.onPixel((input, right, one) -> onEllipse(input, one)));

    private ArcDecision() {}

    /** Tells the value at column u − 1, which decides on the row of column u where 0 ≤ u ≤ v. */
    static Message onCircle(JsonNode input, Pixel at) {
        if (input.path("radius").asLong() > LARGEST) return Message.NONE;
        List<JsonNode> steps = Walk.of("circle", "midpoint", input.toString()).steps();
        long[] apart = apart(input, at);
        long u = Math.min(apart[0], apart[1]);
        Pixel last = pixel(steps.get(steps.size() - 1));
        if (u > last.x()) return Decisions.message("circle", "end", last);
        if (u == 0) return Decisions.message("circle", "start", pixel(steps.get(0)));
        JsonNode before = steps.get((int) u - 1);
        Pixel next = pixel(steps.get((int) u));
        return Decisions.message(
                "circle",
                next.y() == pixel(before).y() ? "stays" : "falls",
                pixel(before),
                Decisions.number(before.path("decision")),
                next);
    }

    /** The value at a pixel says that the walk goes no further in its column, or in its row. */
    static Message onEllipse(JsonNode input, Pixel at) {
        if (input.path("rx").asLong() + input.path("ry").asLong() > LARGEST) return Message.NONE;
        List<JsonNode> steps = Walk.of("ellipse", "midpoint", input.toString()).steps();
        long[] apart = apart(input, at);
        Optional<JsonNode> itself =
                steps.stream()
                        .filter(one -> one.path("u").asLong() == apart[0])
                        .filter(one -> one.path("v").asLong() == apart[1])
                        .findFirst();
        return itself.or(() -> steps.stream().filter(one -> decidesOn(one, apart)).findFirst())
                .map(ArcDecision::onEllipse)
                .orElse(Message.NONE);
    }

    private static boolean decidesOn(JsonNode step, long[] apart) {
        return isOfColumn(step)
                ? step.path("u").asLong() == apart[0]
                : step.path("v").asLong() == apart[1];
    }

    private static boolean isOfColumn(JsonNode step) {
        return step.path("decision").asDouble() < 0;
    }

    private static Message onEllipse(JsonNode step) {
        return Decisions.message(
                "ellipse",
                isOfColumn(step) ? "column" : "row",
                pixel(step),
                Decisions.number(step.path("decision")));
    }

    /** How far the pixel is from the centre along x and y. */
    private static long[] apart(JsonNode input, Pixel at) {
        JsonNode center = input.path("center");
        return new long[] {
            Math.abs(at.x() - center.path(0).asLong()), Math.abs(at.y() - center.path(1).asLong())
        };
    }

    private static Pixel pixel(JsonNode step) {
        return new Pixel(step.path("u").asInt(), step.path("v").asInt());
    }
}
