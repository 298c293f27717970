package rasterlab.engine.raster;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import rasterlab.contract.Pixels;
import rasterlab.engine.study.LimitReached;

/**
 * Keeps every write in order: replay, write counts and the first difference are read from it.
 *
 * <p>A writer that goes on beyond the limit is stopped by {@link LimitReached}.
 */
public final class PixelRecording implements Pixels {
    private final int limit;
    private int[] xs = new int[64];
    private int[] ys = new int[64];
    private int size;

    /**
     * @param limit the most writes to accept, at least 1
     */
    public PixelRecording(int limit) {
        if (limit < 1)
            throw new IllegalArgumentException("limit must be at least 1 pixel, got " + limit);
        this.limit = limit;
    }

    @Override
    public void plot(int x, int y) {
        if (size == limit) throw new LimitReached(limit, this);
        if (size == xs.length) {
            int grown = (int) Math.min(limit, 2L * size);
            xs = Arrays.copyOf(xs, grown);
            ys = Arrays.copyOf(ys, grown);
        }
        xs[size] = x;
        ys[size] = y;
        size++;
    }

    /** Number of writes, counting a pixel as often as it was written. */
    public int size() {
        return size;
    }

    /** Column of write {@code index}, 0 being the first. */
    public int x(int index) {
        return xs[checked(index)];
    }

    /** Row of write {@code index}, 0 being the first. */
    public int y(int index) {
        return ys[checked(index)];
    }

    /** Index of the first write to a pixel that was written before; {@link #size} if none was. */
    public int firstRepeated() {
        Set<Long> seen = new HashSet<>();
        int index = 0;
        while (index < size && seen.add((long) xs[index] << 32 | ys[index] & 0xFFFF_FFFFL)) index++;
        return index;
    }

    private int checked(int index) {
        if (index < 0 || index >= size)
            throw new IndexOutOfBoundsException(
                    "write " + index + " of " + size + " recorded ones");
        return index;
    }
}
