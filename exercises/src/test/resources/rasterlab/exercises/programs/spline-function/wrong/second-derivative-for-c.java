import rasterlab.contract.*;

public class MyMethod implements SplineFunction {

    public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
        int n = x.length;
        for (int i = 1; i < n; i++)
            if (!(x[i] > x[i - 1]))
                throw new IllegalArgumentException("knot " + i + " is not larger: " + x[i]);
        double[] h = new double[n - 1], e = new double[n - 1];
        for (int i = 0; i < n - 1; i++) {
            h[i] = x[i + 1] - x[i];
            e[i] = (y[i + 1] - y[i]) / h[i];
        }
        double[] lo = new double[n], di = new double[n], up = new double[n], b = new double[n];
        for (int i = 1; i < n - 1; i++) {
            lo[i] = h[i - 1];
            di[i] = 2 * (h[i - 1] + h[i]);
            up[i] = h[i];
            b[i] = 6 * (e[i] - e[i - 1]);
        }
        if (ends.kind() == SplineEnds.Kind.NATURAL) {
            di[0] = di[n - 1] = 1;
        } else {
            di[0] = 2 * h[0];
            up[0] = h[0];
            b[0] = 6 * (e[0] - ends.left());
            lo[n - 1] = h[n - 2];
            di[n - 1] = 2 * h[n - 2];
            b[n - 1] = 6 * (ends.right() - e[n - 2]);
        }
        for (int i = 1; i < n; i++) {
            double m = lo[i] / di[i - 1];
            di[i] -= m * up[i - 1];
            b[i] -= m * b[i - 1];
        }
        double[] M = new double[n];
        M[n - 1] = b[n - 1] / di[n - 1];
        for (int i = n - 2; i >= 0; i--) M[i] = (b[i] - up[i] * M[i + 1]) / di[i];
        double[] r = new double[4 * (n - 1)];
        for (int i = 0; i < n - 1; i++) {
            r[4 * i] = y[i];
            r[4 * i + 1] = e[i] - h[i] * (2 * M[i] + M[i + 1]) / 6;
            r[4 * i + 2] = M[i];
            r[4 * i + 3] = (M[i + 1] - M[i]) / (6 * h[i]);
        }
        return r;
    }
}
