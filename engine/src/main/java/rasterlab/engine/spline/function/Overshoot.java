package rasterlab.engine.spline.function;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import rasterlab.engine.range.Bounds;

/**
 * Where a piecewise cubic leaves the values of its two knots.
 *
 * <p>The extremes of {@code a + b·s + c·s² + d·s³} are at the roots of {@code b + 2·c·s + 3·d·s²}.
 *
 * @param piece from 0
 * @param x where it is farthest outside
 * @param y the value there
 * @param beyond the nearer of the two knots' values
 */
public record Overshoot(int piece, double x, double y, double beyond) {
    /** The share of the two values below which a difference is rounding. */
    private static final double ROUNDING = 1e-12;

    public Overshoot {
        Bounds.requireAtLeast("piece", piece, 0);
    }

    /** How far outside the value is; above 0. */
    public double by() {
        return Math.abs(y - beyond);
    }

    /**
     * The farthest place outside, above and below, of each piece that has any; by rising x.
     *
     * @param x the knots, strictly increasing
     * @param y their values
     * @param coefficients four for each piece, as a spline function's method gives them
     */
    public static List<Overshoot> all(double[] x, double[] y, double[] coefficients) {
        var found = new ArrayList<Overshoot>();
        for (int piece = 0; piece + 1 < x.length; piece++) {
            int k = 4 * piece;
            double a = coefficients[k];
            double b = coefficients[k + 1];
            double c = coefficients[k + 2];
            double d = coefficients[k + 3];
            double low = Math.min(y[piece], y[piece + 1]);
            double high = Math.max(y[piece], y[piece + 1]);
            double allowed = ROUNDING * Math.max(Math.abs(low), Math.abs(high));
            for (double s : extremes(b, c, d, x[piece + 1] - x[piece])) {
                double value = a + s * (b + s * (c + s * d));
                double beyond = value > high ? high : low;
                if (value > high + allowed || value < low - allowed)
                    found.add(new Overshoot(piece, x[piece] + s, value, beyond));
            }
        }
        return found;
    }

    /** The roots of b + 2·c·s + 3·d·s² strictly between 0 and {@code width}, by size. */
    private static double[] extremes(double b, double c, double d, double width) {
        double root = Math.sqrt(c * c - 3 * d * b);
        if (Double.isNaN(root)) return new double[0];
        double q = -(c + Math.copySign(root, c));
        return DoubleStream.of(q / (3 * d), b / q)
                .filter(s -> s > 0 && s < width)
                .sorted()
                .distinct()
                .toArray();
    }
}
