package rasterlab.app.line;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.IntStream;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;

/** The pixels that a method sent although they are not exact or were sent before. */
final class ExtraWrites {
    static final ExtraWrites NONE = new ExtraWrites(new int[0]);

    /** The places of the writes among all that were sent, from 0, ascending. */
    private final int[] places;

    private ExtraWrites(int[] places) {
        this.places = places;
    }

    static ExtraWrites of(PixelDifference difference, PixelRecording sent) {
        PixelSet wrong = difference.extra();
        if (wrong.isEmpty() && difference.right().size() == sent.size()) return NONE;
        Set<Long> before = new HashSet<>();
        return new ExtraWrites(
                IntStream.range(0, sent.size())
                        .filter(
                                i ->
                                        !before.add(place(sent.x(i), sent.y(i)))
                                                || wrong.contains(sent.x(i), sent.y(i)))
                        .toArray());
    }

    private static long place(int x, int y) {
        return (long) x << 32 | y & 0xFFFF_FFFFL;
    }

    /** How many of the first pixels that were sent. */
    int among(int first) {
        int at = Arrays.binarySearch(places, first);
        return at < 0 ? -at - 1 : at;
    }
}
