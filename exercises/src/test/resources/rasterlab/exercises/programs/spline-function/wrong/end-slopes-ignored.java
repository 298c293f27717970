import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;

public class MySpline implements SplineFunction {
    @Override
    public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
        int n = x.length - 1;
        for (int i = 0; i < n; i++)
            if (!(x[i] < x[i + 1]) || Double.isNaN(y[i + 1]))
                throw new IllegalArgumentException("bad point " + (i + 1));
        double[] h = new double[n];
        double[] slope = new double[n];
        for (int i = 0; i < n; i++) {
            h[i] = x[i + 1] - x[i];
            slope[i] = (y[i + 1] - y[i]) / h[i];
        }
        // p[i]·m[i] + h[i]·m[i + 1] = q[i] after the rows above are used
        double[] p = new double[n + 1];
        double[] q = new double[n + 1];
        double first = 0;
        double below = 0;
        p[0] = 1;
        p[n] = 1;
        for (int i = 1; i < n; i++) {
            double w = h[i - 1] / p[i - 1];
            p[i] = 2 * (h[i - 1] + h[i]) - w * (i == 1 ? first : h[i - 1]);
            q[i] = 6 * (slope[i] - slope[i - 1]) - w * q[i - 1];
        }
        double w = below / p[n - 1];
        p[n] -= w * (n == 1 ? first : h[n - 1]);
        q[n] -= w * q[n - 1];
        double[] m = new double[n + 1];
        m[n] = q[n] / p[n];
        for (int i = n - 1; i >= 0; i--) m[i] = (q[i] - (i == 0 ? first : h[i]) * m[i + 1]) / p[i];
        double[] out = new double[4 * n];
        for (int i = 0; i < n; i++) {
            double a = y[i];
            double b = slope[i] - h[i] * (2 * m[i] + m[i + 1]) / 6;
            double c = m[i] / 2;
            double d = (m[i + 1] - m[i]) / (6 * h[i]);
            out[4 * i] = a;
            out[4 * i + 1] = b;
            out[4 * i + 2] = c;
            out[4 * i + 3] = d;
        }
        return out;
    }
}
