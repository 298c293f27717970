package rasterlab.engine.clip.exact;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;

/**
 * A fraction in lowest terms, for exact answers.
 *
 * <p>The references' own, of whole numbers; methods count in {@code clip.Fraction}, of decimals.
 * The two share no code, so that a fault in one cannot hide in the other.
 *
 * @param over any whole number
 * @param under above 0
 */
record Ratio(BigInteger over, BigInteger under) implements Comparable<Ratio> {
    static final Ratio ZERO = new Ratio(BigInteger.ZERO, BigInteger.ONE);
    private static final MathContext DIGITS = new MathContext(40);

    /** The number a double stands for: mantissa·2^exponent. */
    static Ratio of(double value) {
        if (!Double.isFinite(value))
            throw new IllegalArgumentException("no fraction is equal to " + value);
        int exponent = Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - 52;
        BigInteger mantissa = BigInteger.valueOf((long) Math.scalb(value, -exponent));
        return exponent >= 0
                ? new Ratio(mantissa.shiftLeft(exponent), BigInteger.ONE)
                : lowest(mantissa, BigInteger.ONE.shiftLeft(-exponent));
    }

    private static Ratio lowest(BigInteger over, BigInteger under) {
        if (under.signum() > 0 && under.bitCount() == 1) return shifted(over, under);
        BigInteger shared = over.gcd(under);
        if (under.signum() < 0) shared = shared.negate();
        return new Ratio(over.divide(shared), under.divide(shared));
    }

    /** The fraction where {@code under} is a power of two, as of all doubles: without dividing. */
    private static Ratio shifted(BigInteger over, BigInteger under) {
        int shared = under.getLowestSetBit();
        if (over.signum() != 0) shared = Math.min(shared, over.getLowestSetBit());
        return new Ratio(over.shiftRight(shared), under.shiftRight(shared));
    }

    Ratio plus(Ratio other) {
        return lowest(
                over.multiply(other.under).add(other.over.multiply(under)),
                under.multiply(other.under));
    }

    Ratio minus(Ratio other) {
        return plus(new Ratio(other.over.negate(), other.under));
    }

    Ratio times(Ratio other) {
        return lowest(over.multiply(other.over), under.multiply(other.under));
    }

    Ratio by(Ratio divisor) {
        return lowest(over.multiply(divisor.under), under.multiply(divisor.over));
    }

    int signum() {
        return over.signum();
    }

    @Override
    public int compareTo(Ratio other) {
        return over.multiply(other.under).compareTo(other.over.multiply(under));
    }

    /** The nearest double. */
    double toDouble() {
        return new BigDecimal(over).divide(new BigDecimal(under), DIGITS).doubleValue();
    }
}
