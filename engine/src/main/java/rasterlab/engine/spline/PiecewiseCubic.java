package rasterlab.engine.spline;

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
    private final boolean periodic;

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
        periodic = ends.kind() == SplineEnds.Kind.PERIODIC;
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

    /** The same, whatever comes out: NaN and infinities as well. */
    double[] unchecked(double[] places) {
        return Arrays.stream(places).map(this::at).toArray();
    }

    private double at(double place) {
        double inside = periodic ? wrapped(place) : place;
        int found = Arrays.binarySearch(x, inside);
        int below = found >= 0 ? found : -found - 2;
        int piece = Math.max(0, Math.min(below, x.length - 2));
        double s = inside - x[piece];
        int c = 4 * piece;
        return coefficients[c]
                + s * (coefficients[c + 1] + s * (coefficients[c + 2] + s * coefficients[c + 3]));
    }

    private double wrapped(double place) {
        double first = x[0];
        double last = x[x.length - 1];
        if (place >= first && place <= last) return place;
        double rest = (place - first) % (last - first);
        return rest < 0 ? last + rest : first + rest;
    }
}
