package rasterlab.engine.visibility.buffer;

/**
 * Window depth (nearest − nearness)/(nearest − farthest) in [0, 1] as a whole number of n bits, by
 * one addition per pixel.
 *
 * <p>The sum along a span is a whole number too, with so many bits behind the point, in which the
 * step is rounded: over p pixels it drifts by up to (p + 1)·2^−(fraction + 1) codes. The largest
 * number, 2ⁿ − 1, is left to empty pixels.
 */
final class FixedCodes implements DepthCodes {
    /** A sum stays below 2⁶²: no step leads farther than 2⁶¹ in {@code 2¹³} pixels. */
    private static final double MOST_STEP = 0x1p48;

    private static final double MOST_SUM = 0x1p61;

    private final int fraction;
    private final int offset;
    private final double nearest;
    private final double perNearness;
    private final long highest;
    private final long half;

    /**
     * @param bits 1 to 32
     * @param fraction bits behind the point of a sum, at least 1; at most 48 with {@code bits}
     */
    FixedCodes(int bits, int fraction, NearnessRange range) {
        this.fraction = fraction;
        offset = bits == Integer.SIZE ? Integer.MIN_VALUE : 0;
        nearest = range.nearest();
        highest = (1L << bits) - 2;
        perNearness = Math.scalb(highest * range.scale(), fraction);
        half = 1L << fraction - 1;
    }

    @Override
    public void row(double base, double perColumn, int from, int to, int[] codes) {
        double first = (nearest - (base + from * perColumn)) * perNearness;
        long sum = Math.round(limited(first, MOST_SUM));
        long step = Math.round(limited(-perColumn * perNearness, MOST_STEP));
        for (int i = 0; i < to - from; i++) {
            long code = Math.max(0, Math.min(highest, sum + half >> fraction));
            codes[i] = (int) (code + offset);
            sum += step;
        }
    }

    /** The whole number, from 0 on the near plane. */
    @Override
    public double depth(int code) {
        return (double) ((long) code - offset);
    }

    @Override
    public boolean largerIsNearer() {
        return false;
    }

    private static double limited(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }
}
