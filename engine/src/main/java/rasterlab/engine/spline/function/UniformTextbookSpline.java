package rasterlab.engine.spline.function;

import java.util.Arrays;
import rasterlab.contract.SplineEnds;

/**
 * The cubic spline as it is printed for a parameter: every piece is one step long, whatever knots
 * are given, and both ends are natural or have their slopes.
 *
 * <p>The slopes D solve 2·D[0] + D[1] = 3·(y[1] − y[0]), D[i−1] + 4·D[i] + D[i+1] = 3·(y[i+1] −
 * y[i−1]) and the mirror at the last knot, or D[0] and D[m] are the slopes that are given times the
 * width h there; piece i is then stretched to its width. Where widths differ the slope jumps, since
 * D/h is another one on either side, and between equal knots h is 0. Nothing is refused; other ends
 * are taken for natural ones.
 *
 * <p>Source: R. H. Bartels, J. C. Beatty, B. A. Barsky, An Introduction to Splines for Use in
 * Computer Graphics and Geometric Modeling, 1987, chapter 3.
 */
public final class UniformTextbookSpline implements SteppedSpline {
    @Override
    public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
        double[] slopes = right(x, y, ends);
        walk(slopes, ends).drain();
        int pieces = Math.max(0, x.length - 1);
        var coefficients = new double[4 * pieces];
        for (int i = 0; i < pieces; i++) {
            double h = x[i + 1] - x[i];
            double rise = y[i + 1] - y[i];
            coefficients[4 * i] = y[i];
            coefficients[4 * i + 1] = slopes[i] / h;
            coefficients[4 * i + 2] = (3 * rise - 2 * slopes[i] - slopes[i + 1]) / (h * h);
            coefficients[4 * i + 3] = (slopes[i] + slopes[i + 1] - 2 * rise) / (h * h * h);
        }
        return coefficients;
    }

    @Override
    public SplineWalk walk(double[] x, double[] y, SplineEnds ends) {
        return walk(right(x, y, ends), ends);
    }

    private static TridiagonalWalk walk(double[] slopes, SplineEnds ends) {
        int n = slopes.length;
        boolean given = ends.kind() == SplineEnds.Kind.SLOPES;
        var lower = new double[n];
        var diagonal = new double[n];
        Arrays.fill(lower, 1);
        Arrays.fill(diagonal, 4);
        double[] upper = lower.clone();
        if (n > 0) diagonal[0] = diagonal[n - 1] = given ? 1 : 2;
        if (n > 0 && given) upper[0] = lower[n - 1] = 0;
        return new TridiagonalWalk(lower, diagonal, upper, slopes);
    }

    private static double[] right(double[] x, double[] y, SplineEnds ends) {
        int last = y.length - 1;
        var right = new double[y.length];
        for (int i = 0; i < right.length; i++)
            right[i] = 3 * (y[Math.min(i + 1, last)] - y[Math.max(i - 1, 0)]);
        if (ends.kind() == SplineEnds.Kind.SLOPES && last > 0) {
            right[0] = ends.left() * (x[1] - x[0]);
            right[last] = ends.right() * (x[last] - x[last - 1]);
        }
        return right;
    }

    @Override
    public String decisionFormula() {
        return "eliminate: pivot p[i]; substitute: slope D[i] = (r[i] − D[i+1]) / p[i]";
    }
}
