package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import rasterlab.engine.raster.Pixel;
import rasterlab.exercises.score.Message;

/** Says by which value a right method of a topic decides on an item. */
interface Decision {
    /**
     * The sentence on that item; empty where the method decides nothing there.
     *
     * @param input a JSON object, as {@code ./lab run} takes it
     * @param right the right answer to it
     */
    Message on(JsonNode input, JsonNode right, DifferingItem at);

    /** The decision on a pixel, of a method that decides on such. */
    static Decision onPixel(OnPixel decision) {
        return (input, right, at) ->
                at.pixel().map(one -> decision.on(input, right, one)).orElse(Message.NONE);
    }

    /** Says by which value a method decides on a pixel. */
    interface OnPixel {
        Message on(JsonNode input, JsonNode right, Pixel pixel);
    }
}
