package rasterlab.engine.spline.function;

import java.math.BigDecimal;
import java.util.Arrays;
import rasterlab.contract.SplineEnds;

/**
 * The values of a function that {@link rasterlab.contract.SplineFunction} found.
 *
 * <p>Piece i holds on [x[i], x[i + 1]). Outside the knots the first and the last piece go on; where
 * the ends are periodic, so does the period.
 */
public final class PiecewiseCubic {
    private final double[] x;
    private final double[] coefficients;
    private final boolean folds;

    /**
     * @param coefficients four for each piece, as {@code SplineFunction.coefficients} gives them
     */
    public PiecewiseCubic(double[] x, double[] coefficients, SplineEnds ends) {
        if (coefficients.length != 4 * (x.length - 1))
            throw new IllegalArgumentException(
                    "coefficients: needs four for each of %d pieces, got %d"
                            .formatted(x.length - 1, coefficients.length));
        this.x = x.clone();
        this.coefficients = coefficients.clone();
        folds =
                ends.kind() == SplineEnds.Kind.PERIODIC
                        && x[0] < x[x.length - 1]
                        && Arrays.stream(x).allMatch(Double::isFinite);
    }

    /**
     * The values at all {@code places}.
     *
     * @throws IllegalArgumentException if a place is not finite or its value is beyond the doubles
     */
    public double[] at(double[] places) {
        var values = new double[places.length];
        for (int i = 0; i < places.length; i++) {
            if (!Double.isFinite(places[i]))
                throw new IllegalArgumentException(
                        "at[%d] must be finite, got %s".formatted(i, places[i]));
            values[i] = at(places[i]);
            if (!Double.isFinite(values[i]))
                throw new IllegalArgumentException(
                        "at[%d] = %s: the value there is beyond the doubles' range"
                                .formatted(i, places[i]));
        }
        return values;
    }

    /** The values, whatever comes out: NaN and infinities as well. */
    double[] unchecked(double[] places) {
        return Arrays.stream(places).map(this::at).toArray();
    }

    private double at(double place) {
        boolean inside = place >= x[0] && place <= x[x.length - 1];
        if (folds && !inside && Double.isFinite(place)) return at(folded(place));
        int piece = piece(place);
        return value(piece, place - x[piece]);
    }

    private double at(BigDecimal inside) {
        int piece = piece(inside.doubleValue());
        return value(piece, inside.subtract(new BigDecimal(x[piece])).doubleValue());
    }

    /**
     * The place folded exactly: a narrow piece would make a wrong value of a place that was
     * rounded. The references share none of it, see {@link SplineProblem#folded}.
     */
    private BigDecimal folded(double place) {
        var first = new BigDecimal(x[0]);
        var last = new BigDecimal(x[x.length - 1]);
        BigDecimal rest = new BigDecimal(place).subtract(first).remainder(last.subtract(first));
        return (rest.signum() < 0 ? last : first).add(rest);
    }

    private int piece(double place) {
        int found = Arrays.binarySearch(x, place);
        int below = found >= 0 ? found : -found - 2;
        return Math.max(0, Math.min(below, x.length - 2));
    }

    private double value(int piece, double s) {
        int c = 4 * piece;
        return coefficients[c]
                + s * (coefficients[c + 1] + s * (coefficients[c + 2] + s * coefficients[c + 3]));
    }
}
