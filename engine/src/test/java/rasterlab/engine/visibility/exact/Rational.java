package rasterlab.engine.visibility.exact;

import java.math.BigDecimal;
import java.math.BigInteger;

/**
 * The quotient over·2^shift / under. Only powers of two are taken out, so that the doubles of a
 * sum, whose divisors are such powers, do not multiply them.
 *
 * @param under odd and above 0
 */
record Rational(BigInteger over, BigInteger under, int shift) implements Comparable<Rational> {
    static final Rational ZERO = new Rational(BigInteger.ZERO, BigInteger.ONE, 0);

    /** A finite double, exactly: its decimals are those of a whole number over a power of two. */
    static Rational of(double value) {
        int shift = 0;
        var whole = new BigDecimal(value);
        if (whole.scale() > 0) {
            // A double with n decimals is a whole number of 2⁻ⁿ.
            shift = -whole.scale();
            whole = whole.multiply(BigDecimal.valueOf(2).pow(whole.scale()));
        }
        return new Rational(whole.toBigIntegerExact(), BigInteger.ONE, shift);
    }

    Rational plus(Rational other) {
        int least = Math.min(shift, other.shift);
        BigInteger one = over.shiftLeft(shift - least);
        BigInteger two = other.over.shiftLeft(other.shift - least);
        return under.equals(other.under)
                ? new Rational(one.add(two), under, least)
                : new Rational(
                        one.multiply(other.under).add(two.multiply(under)),
                        under.multiply(other.under),
                        least);
    }

    Rational minus(Rational other) {
        return plus(new Rational(other.over.negate(), other.under, other.shift));
    }

    Rational times(Rational other) {
        return new Rational(
                over.multiply(other.over), under.multiply(other.under), shift + other.shift);
    }

    Rational dividedBy(Rational other) {
        int twos = other.over.getLowestSetBit();
        BigInteger odd = other.over.abs().shiftRight(twos);
        BigInteger product = over.multiply(other.under);
        return new Rational(
                other.signum() < 0 ? product.negate() : product,
                under.multiply(odd),
                shift - other.shift - twos);
    }

    int signum() {
        return over.signum();
    }

    Rational size() {
        return new Rational(over.abs(), under, shift);
    }

    @Override
    public int compareTo(Rational other) {
        return minus(other).signum();
    }
}
