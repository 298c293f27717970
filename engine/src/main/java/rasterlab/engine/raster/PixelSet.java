package rasterlab.engine.raster;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Pixels without order or repetition, listed row by row and within a row by column; any int
 * coordinates.
 */
public final class PixelSet {
    public static final PixelSet EMPTY = new PixelSet(new long[0]);

    /** Row in the upper half, column in the lower, its sign bit flipped: sorts row by row. */
    private final long[] packed;

    private PixelSet(long[] packed) {
        this.packed = packed;
    }

    /** Every pixel that was written at least once. */
    public static PixelSet of(PixelRecording recording) {
        return new PixelSet(
                IntStream.range(0, recording.size())
                        .mapToLong(i -> pack(recording.x(i), recording.y(i)))
                        .sorted()
                        .distinct()
                        .toArray());
    }

    public int size() {
        return packed.length;
    }

    public boolean isEmpty() {
        return packed.length == 0;
    }

    /** Column of pixel {@code index} in the order of the list, 0 being the first. */
    public int x(int index) {
        return (int) packed[index] ^ Integer.MIN_VALUE;
    }

    /** Row of pixel {@code index} in the order of the list, 0 being the first. */
    public int y(int index) {
        return (int) (packed[index] >> 32);
    }

    public boolean contains(int x, int y) {
        return Arrays.binarySearch(packed, pack(x, y)) >= 0;
    }

    /** The pixels that {@code predicate} accepts. */
    public PixelSet filter(PixelPredicate predicate) {
        return new PixelSet(
                IntStream.range(0, size())
                        .filter(i -> predicate.test(x(i), y(i)))
                        .mapToLong(i -> packed[i])
                        .toArray());
    }

    private static long pack(int x, int y) {
        return (long) y << 32 | (x ^ Integer.MIN_VALUE) & 0xFFFF_FFFFL;
    }
}
