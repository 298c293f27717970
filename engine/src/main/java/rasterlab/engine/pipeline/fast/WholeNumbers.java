package rasterlab.engine.pipeline.fast;

/** Rounding by addition: no conversion. */
final class WholeNumbers {
    /** Leaves, when added to a number below 2⁵¹, the nearest whole one in the sum's lowest bits. */
    static final double ROUND = 0x1.8p52;

    private WholeNumbers() {}

    /** The nearest whole number, or its lowest bits where that is no int. */
    static int nearest(double value) {
        return lowestBits(value + ROUND);
    }

    /** The number that adding {@link #ROUND} has left. */
    static int lowestBits(double sum) {
        return (int) Double.doubleToRawLongBits(sum);
    }
}
