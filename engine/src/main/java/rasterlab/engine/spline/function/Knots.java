package rasterlab.engine.spline.function;

import rasterlab.contract.SplineEnds;

/**
 * Checked knots, and what every method starts from: widths and slopes of the secants.
 *
 * <p>Widths of 10⁻⁷⁵ to 10⁷⁵ and values up to 10⁷⁵, the largest not below 10⁻⁷⁵ unless all are 0,
 * keep every coefficient, at most about value / width³, inside the doubles.
 */
final class Knots {
    static final double LARGEST = 1e75;
    static final double SMALLEST = 1e-75;
    private static final double STEEPEST = 1e150;

    /** Number of pieces, one less than the knots. */
    final int pieces;

    /** Values at the knots. */
    final double[] y;

    /** h[i] = x[i + 1] − x[i]. */
    final double[] width;

    /** δ[i] = (y[i + 1] − y[i]) / h[i]. */
    final double[] secant;

    Knots(double[] x, double[] y, SplineEnds ends) {
        requireCounts(x.length, y.length);
        pieces = x.length - 1;
        this.y = y.clone();
        width = new double[pieces];
        secant = new double[pieces];
        double largest = 0;
        for (int i = 0; i <= pieces; i++) {
            largest = Math.max(largest, requireValue(i, y[i]));
            requireFinite(i, x[i]);
            if (i > 0) measure(i - 1, x[i - 1], x[i]);
        }
        if (largest > 0 && largest < SMALLEST)
            throw new IllegalArgumentException(
                    "y: the largest |y| must be 0 or at least " + SMALLEST + ", got " + largest);
        requireEnds(ends);
    }

    private static void requireCounts(int knots, int values) {
        if (knots < 2)
            throw new IllegalArgumentException("x: needs at least 2 knots, got " + knots);
        if (values != knots)
            throw new IllegalArgumentException(
                    "y: needs one value for each of " + knots + " knots, got " + values);
    }

    private static double requireValue(int i, double value) {
        if (!(Math.abs(value) <= LARGEST))
            throw new IllegalArgumentException(
                    "y[%d] must be from %s to %s, got %s".formatted(i, -LARGEST, LARGEST, value));
        return Math.abs(value);
    }

    private static void requireFinite(int i, double knot) {
        if (!Double.isFinite(knot))
            throw new IllegalArgumentException("x[" + i + "] must be finite, got " + knot);
    }

    private void measure(int i, double from, double to) {
        if (!(to > from))
            throw new IllegalArgumentException(
                    "x[" + (i + 1) + "] must be above x[" + i + "] = " + from + ", got " + to);
        double h = to - from;
        if (h < SMALLEST || h > LARGEST)
            throw new IllegalArgumentException(
                    "x[%d] − x[%d] must be from %s to %s, got %s"
                            .formatted(i + 1, i, SMALLEST, LARGEST, h));
        width[i] = h;
        secant[i] = (y[i + 1] - y[i]) / h;
    }

    private void requireEnds(SplineEnds ends) {
        requireSlope("left", ends.left());
        requireSlope("right", ends.right());
        if (ends.kind() == SplineEnds.Kind.PERIODIC && y[0] != y[pieces])
            throw new IllegalArgumentException(
                    "y[%d] must equal y[0] = %s where the ends are periodic, got %s"
                            .formatted(pieces, y[0], y[pieces]));
    }

    private static void requireSlope(String end, double slope) {
        double size = Math.abs(slope);
        if (size != 0 && (size > STEEPEST || size < 1 / STEEPEST))
            throw new IllegalArgumentException(
                    "ends: %s slope must be 0 or in ±%s..±%s, got %s"
                            .formatted(end, 1 / STEEPEST, STEEPEST, slope));
    }

    /** Share of the piece after knot {@code i} in both pieces at it. */
    double shareAfter(int i) {
        return width[i] / (width[i - 1] + width[i]);
    }

    /** Share of the piece before knot {@code i} in both pieces at it. */
    double shareBefore(int i) {
        return width[i - 1] / (width[i - 1] + width[i]);
    }

    /** 6·(δ[after] − δ[before]) / (h[before] + h[after]): six second divided differences. */
    double bend(int before, int after) {
        return 6 * (secant[after] - secant[before]) / (width[before] + width[after]);
    }

    /**
     * Each piece from its values and second derivatives at both ends.
     *
     * @param second one for each knot
     * @throws IllegalArgumentException if a coefficient is beyond the doubles
     */
    double[] bent(double[] second) {
        var all = new double[4 * pieces];
        for (int i = 0; i < pieces; i++) {
            all[4 * i] = y[i];
            all[4 * i + 1] = secant[i] - width[i] * (2 * second[i] + second[i + 1]) / 6;
            all[4 * i + 2] = second[i] / 2;
            all[4 * i + 3] = (second[i + 1] - second[i]) / (6 * width[i]);
        }
        return finite(all);
    }

    /**
     * Each piece from its values and slopes at both ends (Hermite).
     *
     * @param slopes one for each knot
     * @throws IllegalArgumentException if a coefficient is beyond the doubles
     */
    double[] sloping(double[] slopes) {
        var all = new double[4 * pieces];
        for (int i = 0; i < pieces; i++) {
            double rise = slopes[i] - secant[i];
            double fall = slopes[i + 1] - secant[i];
            all[4 * i] = y[i];
            all[4 * i + 1] = slopes[i];
            all[4 * i + 2] = -(2 * rise + fall) / width[i];
            all[4 * i + 3] = (rise + fall) / width[i] / width[i];
        }
        return finite(all);
    }

    private static double[] finite(double[] coefficients) {
        for (int i = 0; i < coefficients.length; i++)
            if (!Double.isFinite(coefficients[i]))
                throw new IllegalArgumentException(
                        "x: coefficients of piece " + i / 4 + " are beyond the doubles' range");
        return coefficients;
    }
}
