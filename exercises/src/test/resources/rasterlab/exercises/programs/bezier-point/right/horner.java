import rasterlab.contract.*;

public class MyMethod implements CurveEvaluator {

    public void at(Curve curve, double[] t, CurvePoints out) {
        for (double u : t) out.point(cast(curve.x(), u), cast(curve.y(), u));
    }

    static double cast(double[] given, double u) {
        int n = given.length - 1;
        double v = 1 - u, b = 1, f = 1, s = given[0] * v;
        if (n == 0) return given[0];
        for (int i = 1; i < n; i++) {
            f *= u;
            b = b * (n - i + 1) / i;
            s = (s + f * b * given[i]) * v;
        }
        return s + f * u * given[n];
    }
}
