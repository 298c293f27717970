package rasterlab.exercises.judging;

import java.util.Optional;
import rasterlab.engine.raster.FirstDifference;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.exercises.score.Message;

/**
 * Says which pixels of an answer are missing, extra or drawn again, whatever order they come in;
 * where none is, which one comes out of order.
 */
final class PixelErrors {
    private final PixelRecording right;
    private final PixelRecording actual;
    private final PixelDifference difference;

    PixelErrors(PixelRecording right, PixelRecording actual) {
        this.right = right;
        this.actual = actual;
        this.difference = PixelDifference.of(right, actual);
    }

    /** The difference from the right answer; empty where they are the same. */
    Message message() {
        Message said =
                counted("pixel.missing", difference.missing())
                        .and(counted("pixel.extra", difference.extra()))
                        .and(again());
        if (!said.isEmpty()) return said;
        Optional<FirstDifference> first = FirstDifference.of(right, actual, difference);
        return first.map(one -> Message.of("pixel.order", one.pixel())).orElse(Message.NONE);
    }

    /**
     * The first pixel that is missing, or extra where none is; empty where the pixels are right.
     */
    Optional<Pixel> first() {
        if (!difference.missing().isEmpty()) return Optional.of(first(difference.missing()));
        if (!difference.extra().isEmpty()) return Optional.of(first(difference.extra()));
        return Optional.empty();
    }

    /** Whether the pixels are the right ones, but some are drawn again. */
    boolean isAgainAlone() {
        return difference.missing().isEmpty()
                && difference.extra().isEmpty()
                && PixelSet.of(actual).size() < actual.size();
    }

    /** The pixels that do not fit the other answers of a method, where {@code right} would. */
    Message unfit() {
        if (!difference.missing().isEmpty())
            return Message.of("pixel.unfit-missing", first(difference.missing()));
        if (!difference.extra().isEmpty())
            return Message.of("pixel.unfit-extra", first(difference.extra()));
        return message();
    }

    /** The number of several, and one of them. */
    private static Message counted(String key, PixelSet pixels) {
        if (pixels.isEmpty()) return Message.NONE;
        return pixels.size() == 1
                ? Message.of(key, first(pixels))
                : Message.of(key + ".several", pixels.size(), first(pixels));
    }

    /** The number of calls for pixels that were drawn before, and the first of them. */
    private Message again() {
        int repeated = actual.size() - PixelSet.of(actual).size();
        if (repeated == 0) return Message.NONE;
        int at = actual.firstRepeated();
        var pixel = new Pixel(actual.x(at), actual.y(at));
        return repeated == 1
                ? Message.of("pixel.again", pixel)
                : Message.of("pixel.again.several", repeated, pixel);
    }

    private static Pixel first(PixelSet pixels) {
        return new Pixel(pixels.x(0), pixels.y(0));
    }
}
