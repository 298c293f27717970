package rasterlab.engine.clip;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * A quotient of decimals without rounding; every double is a finite decimal. Compared by
 * multiplying across.
 *
 * <p>The methods' own; the references count in {@code clip.exact.Ratio}, another representation by
 * other code, so that a fault in one cannot hide in the other.
 *
 * @param over any decimal
 * @param under above 0
 */
public record Fraction(BigDecimal over, BigDecimal under) implements Comparable<Fraction> {
    public static final Fraction ZERO = new Fraction(BigDecimal.ZERO, BigDecimal.ONE);
    public static final Fraction ONE = new Fraction(BigDecimal.ONE, BigDecimal.ONE);

    /** Digits of a new coordinate before it becomes a double: ample for one correct rounding. */
    private static final MathContext DIGITS = new MathContext(40);

    @Override
    public int compareTo(Fraction other) {
        return over.multiply(other.under).compareTo(other.over.multiply(under));
    }

    public int compareTo(double value) {
        return over.compareTo(new BigDecimal(value).multiply(under));
    }

    /** The coordinate this share of the way between two, without rounding. */
    public Fraction way(double from, double to) {
        BigDecimal start = new BigDecimal(from);
        BigDecimal change = new BigDecimal(to).subtract(start);
        return new Fraction(start.multiply(under).add(change.multiply(over)), under);
    }

    /** The nearest double to the coordinate this share of the way between two. */
    public double between(double from, double to) {
        return way(from, to).toDouble();
    }

    public double toDouble() {
        return over.divide(under, DIGITS).doubleValue();
    }
}
