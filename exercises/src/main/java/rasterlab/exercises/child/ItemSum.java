package rasterlab.exercises.child;

import rasterlab.contract.Pixels;

/**
 * Counts items and sums a mix of their numbers, so that the parent sees that they were made. The
 * sum does not depend on the order of the items.
 */
public final class ItemSum implements Pixels {
    /**
     * 2⁶⁴ divided by the golden ratio, odd: spreads neighbours over all bits. Source: D. Knuth, The
     * Art of Computer Programming 3, section 6.4.
     */
    private static final long FOR_X = 0x9E3779B97F4A7C15L;

    /**
     * The second odd number without a pattern. Source: the second 64-bit prime of xxHash, Y.
     * Collet.
     */
    private static final long FOR_Y = 0xC2B2AE3D27D4EB4FL;

    private long count;
    private long sum;

    @Override
    public void plot(int x, int y) {
        count++;
        sum += x * FOR_X ^ y * FOR_Y;
    }

    /** Adds an item of any number of numbers, whose order counts. */
    void add(long... numbers) {
        long mixed = 0;
        for (long number : numbers) mixed = (mixed ^ number * FOR_X) * FOR_Y;
        count++;
        sum += mixed;
    }

    public long count() {
        return count;
    }

    public long sum() {
        return sum;
    }
}
