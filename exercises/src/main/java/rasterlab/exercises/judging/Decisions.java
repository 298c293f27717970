package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import java.math.BigDecimal;
import java.math.MathContext;
import rasterlab.engine.raster.Pixel;
import rasterlab.exercises.score.Message;

/**
 * Says by which value of its recorded walk a right method decides on the first item in which an
 * answer differs. Nothing is said where the topic's methods decide nothing, as those that compute
 * numbers, or where the walk has no such step.
 */
final class Decisions {
    private static final MathContext TOLD = new MathContext(7);

    private Decisions() {}

    /**
     * The sentence on that item.
     *
     * @param input a JSON object, as {@code ./lab run} takes it
     * @param right the right answer to it
     */
    static Message of(String topic, JsonNode input, JsonNode right, Differing at) {
        try {
            return switch (topic) {
                case "line" -> pixel(at, one -> LineDecision.on(input, one));
                case "circle" -> pixel(at, one -> ArcDecision.onCircle(input, one));
                case "ellipse" -> pixel(at, one -> ArcDecision.onEllipse(input, one));
                case "fill" -> pixel(at, one -> AreaDecision.onFill(input, one));
                case "polygon-fill" -> pixel(at, one -> AreaDecision.onPolygon(input, one));
                case "depth-triangle" -> pixel(at, one -> DepthDecision.on(input, right, one));
                case "point-in-triangle", "point-in-polygon", "visible-faces" ->
                        at.index().isPresent()
                                ? TruthDecision.on(topic, input, right, at.index().getAsInt())
                                : Message.NONE;
                default -> Message.NONE;
            };
        } catch (IllegalArgumentException refused) {
            return Message.NONE;
        }
    }

    private interface OnPixel {
        Message said(Pixel pixel);
    }

    private static Message pixel(Differing at, OnPixel decision) {
        return at.pixel().map(decision::said).orElse(Message.NONE);
    }

    /** The sentence of that key in the topic's words. */
    static Message said(String topic, String key, Object... arguments) {
        return Message.of("decided." + topic + "." + key, arguments);
    }

    /** A value as people are told it, with the few digits that they need. */
    static String number(JsonNode value) {
        BigDecimal rounded = value.decimalValue().round(TOLD).stripTrailingZeros();
        return rounded.signum() == 0 ? "0" : rounded.toPlainString();
    }
}
