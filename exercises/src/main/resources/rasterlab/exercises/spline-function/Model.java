import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;

/** Finds the second derivatives at the knots from three unknowns a row, then each piece. */
public class Model implements SplineFunction {
    @Override
    public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
        for (int i = 1; i < x.length; i++)
            if (!(x[i] > x[i - 1]))
                throw new IllegalArgumentException("x[" + i + "] = " + x[i] + " does not increase");
        int m = x.length - 1;
        double[] h = new double[m];
        double[] secant = new double[m];
        for (int i = 0; i < m; i++) {
            h[i] = x[i + 1] - x[i];
            secant[i] = (y[i + 1] - y[i]) / h[i];
        }
        double[] lower = new double[m + 1];
        double[] diagonal = new double[m + 1];
        double[] upper = new double[m + 1];
        double[] right = new double[m + 1];
        diagonal[0] = 1;
        diagonal[m] = 1;
        if (ends.kind() == SplineEnds.Kind.SLOPES) {
            diagonal[0] = 2 * h[0];
            upper[0] = h[0];
            right[0] = 6 * (secant[0] - ends.left());
            lower[m] = h[m - 1];
            diagonal[m] = 2 * h[m - 1];
            right[m] = 6 * (ends.right() - secant[m - 1]);
        }
        for (int i = 1; i < m; i++) {
            lower[i] = h[i - 1];
            diagonal[i] = 2 * (h[i - 1] + h[i]);
            upper[i] = h[i];
            right[i] = 6 * (secant[i] - secant[i - 1]);
        }
        double[] second = solved(lower, diagonal, upper, right);
        double[] all = new double[4 * m];
        for (int i = 0; i < m; i++) {
            all[4 * i] = y[i];
            all[4 * i + 1] = secant[i] - h[i] * (2 * second[i] + second[i + 1]) / 6;
            all[4 * i + 2] = second[i] / 2;
            all[4 * i + 3] = (second[i + 1] - second[i]) / (6 * h[i]);
        }
        return all;
    }

    /** Eliminates downwards, then substitutes upwards. */
    private static double[] solved(double[] lower, double[] diagonal, double[] upper, double[] right) {
        int n = diagonal.length;
        for (int i = 1; i < n; i++) {
            double factor = lower[i] / diagonal[i - 1];
            diagonal[i] -= factor * upper[i - 1];
            right[i] -= factor * right[i - 1];
        }
        for (int i = n - 1; i >= 0; i--) {
            double rest = i == n - 1 ? right[i] : right[i] - upper[i] * right[i + 1];
            right[i] = rest / diagonal[i];
        }
        return right;
    }
}
