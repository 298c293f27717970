package rasterlab.engine.visibility.exact;

import java.math.BigInteger;

/**
 * The number mantissa·2^exponent. Each finite double is one, and so are their sums, differences and
 * products: nothing is rounded.
 */
record Dyadic(BigInteger mantissa, int exponent) implements Scalar<Dyadic> {
    private static final int MANTISSA_BITS = 52;
    private static final long MANTISSA = (1L << MANTISSA_BITS) - 1;
    private static final Dyadic ZERO = new Dyadic(BigInteger.ZERO, 0);

    /** A finite double, exactly. */
    static Dyadic of(double value) {
        if (!Double.isFinite(value))
            throw new IllegalArgumentException("value must be finite, got " + value);
        long bits = Double.doubleToRawLongBits(value) & Long.MAX_VALUE;
        int exponent = (int) (bits >>> MANTISSA_BITS);
        long mantissa = bits & MANTISSA;
        if (exponent == 0) exponent = 1;
        else mantissa |= MANTISSA + 1;
        if (mantissa == 0) return ZERO;
        int zeros = Long.numberOfTrailingZeros(mantissa);
        long odd = value < 0 ? -(mantissa >> zeros) : mantissa >> zeros;
        return new Dyadic(BigInteger.valueOf(odd), exponent + zeros - 1075);
    }

    @Override
    public Dyadic plus(Dyadic other) {
        if (signum() == 0) return other;
        if (other.signum() == 0) return this;
        int least = Math.min(exponent, other.exponent);
        return new Dyadic(at(least).add(other.at(least)), least);
    }

    private BigInteger at(int least) {
        return mantissa.shiftLeft(exponent - least);
    }

    @Override
    public Dyadic minus(Dyadic other) {
        return plus(new Dyadic(other.mantissa.negate(), other.exponent));
    }

    @Override
    public Dyadic times(Dyadic other) {
        return new Dyadic(mantissa.multiply(other.mantissa), exponent + other.exponent);
    }

    /** −1, 0 or 1. */
    int signum() {
        return mantissa.signum();
    }
}
