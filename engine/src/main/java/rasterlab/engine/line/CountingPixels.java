package rasterlab.engine.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.study.LimitReached;

/**
 * Counts pixels and folds their places into a sum, so that a compiler cannot leave the places
 * uncomputed.
 */
final class CountingPixels implements Pixels {
    private final long limit;
    private long count;
    private long places;

    CountingPixels(long limit) {
        this.limit = limit;
    }

    @Override
    public void plot(int x, int y) {
        if (count == limit) throw new LimitReached((int) Math.min(limit, Integer.MAX_VALUE), null);
        count++;
        places += x ^ y;
    }

    long count() {
        // Never true, but only this class knows: the places have to be computed.
        if (places == Long.MIN_VALUE) throw new AssertionError("sum of places overflowed");
        return count;
    }
}
