package rasterlab.app.line.trace;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.IntStream;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;

/** The pixels that a method sent although they are not exact or were sent before. */
public final class ExtraWrites {
    public static final ExtraWrites NONE = new ExtraWrites(new int[0], new int[0]);

    /** The places of the writes among all that were sent, from 0, ascending. */
    private final int[] places;

    /** The places of those that were sent before. */
    private final int[] again;

    private ExtraWrites(int[] places, int[] again) {
        this.places = places;
        this.again = again;
    }

    public static ExtraWrites of(PixelDifference difference, PixelRecording sent) {
        PixelSet wrong = difference.extra();
        if (wrong.isEmpty() && difference.right().size() == sent.size()) return NONE;
        Set<Long> before = new HashSet<>();
        int[] again =
                IntStream.range(0, sent.size())
                        .filter(i -> !before.add(place(sent.x(i), sent.y(i))))
                        .toArray();
        return new ExtraWrites(
                IntStream.range(0, sent.size())
                        .filter(
                                i ->
                                        Arrays.binarySearch(again, i) >= 0
                                                || wrong.contains(sent.x(i), sent.y(i)))
                        .toArray(),
                again);
    }

    private static long place(int x, int y) {
        return (long) x << 32 | y & 0xFFFF_FFFFL;
    }

    /** How many of the first pixels that were sent. */
    public int among(int first) {
        return below(first, places);
    }

    /** How many of the first pixels that were sent had been sent before. */
    public int againAmong(int first) {
        return below(first, again);
    }

    /** The place of one of those that had been sent before, among all that were sent. */
    public int again(int number) {
        return again[number];
    }

    private static int below(int limit, int[] ascending) {
        int at = Arrays.binarySearch(ascending, limit);
        return at < 0 ? -at - 1 : at;
    }
}
