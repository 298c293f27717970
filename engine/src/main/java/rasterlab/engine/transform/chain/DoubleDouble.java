package rasterlab.engine.transform.chain;

/**
 * A number as the sum of two doubles, some 106 bits: {@code high} is the nearest double, {@code
 * low} what it leaves.
 *
 * <p>Each operation is off by at most 2⁻¹⁰² of its result. For magnitudes between 2⁻⁹⁰⁰ and 2⁹⁰⁰ no
 * part overflows or vanishes; beyond 2¹⁰²³ the result is not finite.
 *
 * <p>Source: T. J. Dekker, A floating-point technique for extending the available precision,
 * Numerische Mathematik 18, 1971, pp. 224–242.
 */
record DoubleDouble(double high, double low) {
    static final DoubleDouble ZERO = new DoubleDouble(0, 0);
    static final DoubleDouble ONE = new DoubleDouble(1, 0);

    /** a + b with what its rounding lost. */
    private static DoubleDouble sum(double a, double b) {
        double high = a + b;
        double shadow = high - a;
        return new DoubleDouble(high, (a - (high - shadow)) + (b - shadow));
    }

    /** The sum where |a| ≥ |b| or a is 0. */
    private static DoubleDouble quickSum(double a, double b) {
        double high = a + b;
        return new DoubleDouble(high, b - (high - a));
    }

    DoubleDouble plus(DoubleDouble that) {
        DoubleDouble large = sum(high, that.high);
        DoubleDouble small = sum(low, that.low);
        DoubleDouble carried = quickSum(large.high, large.low + small.high);
        return quickSum(carried.high, carried.low + small.low);
    }

    DoubleDouble times(double factor) {
        double product = high * factor;
        double lost = Math.fma(high, factor, -product);
        return quickSum(product, Math.fma(low, factor, lost));
    }

    /** The quotient as one double. */
    double over(DoubleDouble divisor) {
        double first = high / divisor.high;
        DoubleDouble rest = plus(divisor.times(-first));
        return first + rest.high / divisor.high;
    }

    boolean isFinite() {
        return Double.isFinite(high) && Double.isFinite(low);
    }
}
