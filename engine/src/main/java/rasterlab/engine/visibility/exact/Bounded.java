package rasterlab.engine.visibility.exact;

/**
 * A double and a bound of its error: the number that it stands for is in [value − error, value +
 * error].
 *
 * <p>A sum, a product or a quotient is rounded by at most u·|value| with u = 2⁻⁵³, and near 0 by a
 * product's 2⁻¹⁰⁷⁴; to that come the errors of what it is made from. The bound itself is computed
 * in a few operations, each of which may lose u of it: {@link #ROUNDED_UP} gives back more. What
 * overflows has an infinite bound or NaN, which decides nothing.
 *
 * <p>Source: J. H. Wilkinson, Rounding errors in algebraic processes, 1963 (running error
 * analysis).
 */
record Bounded(double value, double error) implements Scalar<Bounded> {
    private static final double UNIT = 0x1p-53;
    private static final double UNDERFLOW = 8 * Double.MIN_VALUE;

    /** A factor above all that the roundings of a bound can take from it. */
    static final double ROUNDED_UP = 1 + 0x1p-48;

    /** A double, exactly. */
    static Bounded of(double value) {
        return new Bounded(value, 0);
    }

    @Override
    public Bounded plus(Bounded other) {
        return sum(value + other.value, error + other.error);
    }

    @Override
    public Bounded minus(Bounded other) {
        return sum(value - other.value, error + other.error);
    }

    private static Bounded sum(double sum, double errors) {
        return new Bounded(sum, (errors + UNIT * Math.abs(sum)) * ROUNDED_UP);
    }

    @Override
    public Bounded times(Bounded other) {
        double product = value * other.value;
        double passedOn =
                Math.abs(value) * other.error + (Math.abs(other.value) + other.error) * error;
        return new Bounded(product, (passedOn + UNIT * Math.abs(product) + UNDERFLOW) * ROUNDED_UP);
    }

    /** The quotient; with no bound where the divisor may be 0. */
    Bounded over(Bounded divisor) {
        double least = Math.abs(divisor.value) - divisor.error;
        if (!(least > 0)) return new Bounded(Double.NaN, Double.POSITIVE_INFINITY);
        double quotient = value / divisor.value;
        double passedOn = (error + Math.abs(quotient) * divisor.error) / least * ROUNDED_UP;
        return new Bounded(
                quotient, (passedOn + UNIT * Math.abs(quotient) + UNDERFLOW) * ROUNDED_UP);
    }

    /** −1 or 1 where the bound leaves no doubt, 0 where it does. */
    int certainSign() {
        if (value > error) return 1;
        return value < -error ? -1 : 0;
    }
}
