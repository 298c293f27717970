package rasterlab.engine.raster;

import rasterlab.contract.Pixels;
import rasterlab.engine.study.LimitReached;

/** Counts pixels and sums up their places, so that a compiler cannot leave them uncomputed. */
public final class CountingPixels implements Pixels {
    private final long limit;
    private long count;
    private long places;

    /**
     * @param limit the most pixels to accept before the writer is stopped by {@link LimitReached}
     */
    public CountingPixels(long limit) {
        this.limit = limit;
    }

    @Override
    public void plot(int x, int y) {
        if (count == limit) throw new LimitReached((int) Math.min(limit, Integer.MAX_VALUE), null);
        count++;
        places += x ^ y;
    }

    /** Number of pixels so far. */
    public long count() {
        // Fewer than 2³¹ terms of 32 bits never get there, but only a reader knows, no compiler.
        if (places == Long.MIN_VALUE) throw new AssertionError("the sum of places is off");
        return count;
    }
}
