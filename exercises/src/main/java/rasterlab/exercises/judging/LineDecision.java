package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.raster.Pixel;
import rasterlab.exercises.score.Message;

/** The value of Bresenham's method at the pixel before one of a line. */
final class LineDecision {
    private static final String TOPIC = "line";

    static final Map<String, Decision> BY_TOPIC =
            Map.of("line", Decision.onPixel((input, right, one) -> on(input, one)));

    private LineDecision() {}

    /** A line may be long, so that the walk is looked at around the pixel alone. */
    static Message on(JsonNode input, Pixel at) {
        ObjectNode near = input.deepCopy();
        near.putArray("window")
                .add(within(at.x() - 1L))
                .add(within(at.y() - 1L))
                .add(within(at.x() + 1L))
                .add(within(at.y() + 1L));
        List<JsonNode> steps = Walk.of(TOPIC, "bresenham", near.toString()).steps();
        Pixel from = pixel(input.path("from").path(0), input.path("from").path(1));
        Pixel to = pixel(input.path("to").path(0), input.path("to").path(1));
        boolean alongX = Math.abs((long) to.x() - from.x()) >= Math.abs((long) to.y() - from.y());
        Optional<Integer> right = index(steps, at, alongX);
        if (right.isEmpty()) return beyond(steps, from, to);
        if (pixel(steps.get(right.get())).equals(from))
            return Decisions.message(TOPIC, "start", from);
        if (right.get() == 0) return Message.NONE;
        JsonNode before = steps.get(right.get() - 1);
        return step(before, pixel(before), pixel(steps.get(right.get())), alongX);
    }

    private static Message step(JsonNode decided, Pixel before, Pixel next, boolean alongX) {
        boolean across = alongX ? before.y() != next.y() : before.x() != next.x();
        return Decisions.message(
                TOPIC,
                across ? "across" : "along",
                before,
                Decisions.number(decided.path("decision")),
                next);
    }

    /** The step to the pixel, or to the right one of as many steps along the line. */
    private static Optional<Integer> index(List<JsonNode> steps, Pixel at, boolean alongX) {
        for (int i = 0; i < steps.size(); i++) {
            Pixel one = pixel(steps.get(i));
            if (alongX ? one.x() == at.x() : one.y() == at.y()) return Optional.of(i);
        }
        return Optional.empty();
    }

    /** A pixel beside an end, where nothing is to be drawn any more. */
    private static Message beyond(List<JsonNode> steps, Pixel from, Pixel to) {
        List<Pixel> near = steps.stream().map(LineDecision::pixel).toList();
        if (near.contains(to)) return Decisions.message(TOPIC, "end", to);
        return near.contains(from) ? Decisions.message(TOPIC, "start", from) : Message.NONE;
    }

    private static int within(long coordinate) {
        return (int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, coordinate));
    }

    private static Pixel pixel(JsonNode step) {
        return pixel(step.path("x"), step.path("y"));
    }

    private static Pixel pixel(JsonNode x, JsonNode y) {
        return new Pixel(x.asInt(), y.asInt());
    }
}
