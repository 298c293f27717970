package rasterlab.engine.spline;

import java.math.BigInteger;

/**
 * A whole number over a power of two. Every finite double is one, and so are sums and products, so
 * nothing is rounded on the way.
 *
 * @param over any whole number
 * @param places the power of two that it is divided by
 */
record Dyadic(BigInteger over, int places) {
    static final Dyadic ZERO = new Dyadic(BigInteger.ZERO, 0);

    /** A double has 53; with so many more, what is cut off hardly ever decides its last one. */
    private static final int DIGITS = 128;

    /**
     * @throws IllegalArgumentException if {@code value} is not finite
     */
    static Dyadic of(double value) {
        if (!Double.isFinite(value))
            throw new IllegalArgumentException("must be finite, got " + value);
        if (value == 0) return ZERO;
        int exponent = Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - 52;
        long mantissa = (long) Math.scalb(value, -exponent);
        int zeros = Long.numberOfTrailingZeros(mantissa);
        return new Dyadic(BigInteger.valueOf(mantissa >> zeros), -exponent - zeros);
    }

    Dyadic plus(Dyadic other) {
        int most = Math.max(places, other.places);
        return new Dyadic(to(most).add(other.to(most)), most);
    }

    Dyadic minus(Dyadic other) {
        int most = Math.max(places, other.places);
        return new Dyadic(to(most).subtract(other.to(most)), most);
    }

    private BigInteger to(int morePlaces) {
        return over.shiftLeft(morePlaces - places);
    }

    Dyadic times(Dyadic other) {
        return new Dyadic(over.multiply(other.over), places + other.places);
    }

    Dyadic times(BigInteger factor) {
        return new Dyadic(over.multiply(factor), places);
    }

    int floor() {
        return over.shiftRight(places).intValueExact();
    }

    double toDouble() {
        return dividedBy(1);
    }

    /** The quotient, rounded to a double. */
    double dividedBy(int divisor) {
        int shift = over.bitLength() - DIGITS;
        BigInteger digits = shift > 0 ? over.shiftRight(shift) : over.shiftLeft(-shift);
        double quotient = digits.divide(BigInteger.valueOf(divisor)).doubleValue();
        return Math.scalb(quotient, shift - places);
    }
}
