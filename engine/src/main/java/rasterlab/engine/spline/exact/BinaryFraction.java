package rasterlab.engine.spline.exact;

import java.math.BigInteger;

/**
 * The number over/2^places. Every finite double is one, and so are sums and products, so nothing is
 * rounded on the way. Equal numbers may be unequal records: 2/2¹ and 1/2⁰.
 *
 * @param over any whole number
 * @param places below 0 where the number is a multiple of a power of two
 */
record BinaryFraction(BigInteger over, int places) {
    static final BinaryFraction ZERO = new BinaryFraction(BigInteger.ZERO, 0);

    /**
     * The bits that are kept: more than the 53 of a double and one for the half between two of
     * them.
     */
    private static final int BITS = 128;

    /**
     * @throws IllegalArgumentException if {@code value} is not finite
     */
    static BinaryFraction of(double value) {
        if (!Double.isFinite(value))
            throw new IllegalArgumentException("must be finite, got " + value);
        if (value == 0) return ZERO;
        int exponent = Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - 52;
        long mantissa = (long) Math.scalb(value, -exponent);
        int zeros = Long.numberOfTrailingZeros(mantissa);
        return new BinaryFraction(BigInteger.valueOf(mantissa >> zeros), -exponent - zeros);
    }

    BinaryFraction plus(BinaryFraction other) {
        int most = Math.max(places, other.places);
        return new BinaryFraction(to(most).add(other.to(most)), most);
    }

    BinaryFraction minus(BinaryFraction other) {
        int most = Math.max(places, other.places);
        return new BinaryFraction(to(most).subtract(other.to(most)), most);
    }

    private BigInteger to(int morePlaces) {
        return over.shiftLeft(morePlaces - places);
    }

    BinaryFraction times(BinaryFraction other) {
        return new BinaryFraction(over.multiply(other.over), places + other.places);
    }

    BinaryFraction times(BigInteger factor) {
        return new BinaryFraction(over.multiply(factor), places);
    }

    int floor() {
        return over.shiftRight(places).intValueExact();
    }

    double toDouble() {
        return dividedBy(1);
    }

    /**
     * The quotient, rounded once to a double of normal size. Of what is cut off only whether it is
     * 0 counts, and that the last bit tells.
     *
     * @param divisor above 0
     */
    double dividedBy(int divisor) {
        BigInteger size = over.abs();
        int shift = size.bitLength() - BITS;
        BigInteger first = shift > 0 ? size.shiftRight(shift) : size.shiftLeft(-shift);
        BigInteger[] quotient = first.divideAndRemainder(BigInteger.valueOf(divisor));
        boolean more = quotient[1].signum() > 0 || size.getLowestSetBit() < shift;
        BigInteger bits = more ? quotient[0].setBit(0) : quotient[0];
        return Math.scalb(over.signum() * bits.doubleValue(), shift - places);
    }
}
