package rasterlab.engine.spline.function;

import rasterlab.contract.SplineEnds;

/**
 * The values at the knots of a function whose period closes.
 *
 * <p>sin 2π computed in doubles is −2.4·10⁻¹⁶, though its curve is closed. So the first and the
 * last value of a periodic function count as one where they differ by at most {@value #ROUNDING} of
 * the largest value, some eight roundings of it; the first one is then taken for both. Values that
 * differ by more are left for the method to refuse.
 *
 * @param given the values as given
 * @param values the values to compute with
 */
public record ClosedValues(double[] given, double[] values) {
    private static final double ROUNDING = 0x1p-50;

    /** The values, with the last one closed where the ends are periodic. */
    public static ClosedValues of(double[] y, SplineEnds ends) {
        double[] closed = y.clone();
        int last = y.length - 1;
        if (ends.kind() == SplineEnds.Kind.PERIODIC
                && last > 0
                && Math.abs(y[last] - y[0]) <= ROUNDING * largest(y)) closed[last] = y[0];
        return new ClosedValues(y.clone(), closed);
    }

    private static double largest(double[] y) {
        double largest = 0;
        for (double value : y) largest = Math.max(largest, Math.abs(value));
        return largest;
    }

    /** Whether the last value is another than the given one. */
    public boolean moved() {
        int last = given.length - 1;
        return last > 0 && given[last] != values[last];
    }

    /** One English sentence: which value was taken for which, and why. */
    public String note() {
        int last = given.length - 1;
        return "y[%d] = %s is taken as y[0] = %s: the period closes within rounding"
                .formatted(last, given[last], values[last]);
    }
}
