package rasterlab.exercises.judging;

import java.util.Arrays;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Topic;

/**
 * Tells whether two answers of pixels make the same mistake: they draw the same pixels, each as
 * often, and in the same order where the topic asks for one.
 */
final class SamePixels {
    private SamePixels() {}

    static <I> boolean are(
            Topic<?, I, ?> topic, I input, PixelRecording one, PixelRecording other) {
        if (one.size() != other.size()) return false;
        return Arrays.equals(places(one), places(other))
                || Arrays.equals(sorted(one), sorted(other)) && !ordered(topic, input);
    }

    /** Whether the right pixels in another order are not right. */
    @SuppressWarnings("unchecked") // its outputs are pixels
    private static <I> boolean ordered(Topic<?, I, ?> topic, I input) {
        var pixels = (Topic<?, I, PixelRecording>) topic;
        PixelRecording right = pixels.exact(input, topic.mostItems());
        var backwards = new PixelRecording(Integer.MAX_VALUE);
        for (int i = right.size() - 1; i >= 0; i--) backwards.plot(right.x(i), right.y(i));
        return !pixels.correct(pixels.compare(input, right, backwards));
    }

    private static long[] places(PixelRecording pixels) {
        var places = new long[pixels.size()];
        for (int i = 0; i < places.length; i++)
            places[i] = (long) pixels.y(i) << Integer.SIZE | pixels.x(i) & 0xFFFFFFFFL;
        return places;
    }

    private static long[] sorted(PixelRecording pixels) {
        long[] places = places(pixels);
        Arrays.sort(places);
        return places;
    }
}
