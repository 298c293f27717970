import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class AsBezier implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        double[] x = controls(curve.x());
        double[] y = controls(curve.y());
        for (double u : t) out.point(value(x, u), value(y, u));
    }

    private static double[] controls(double[] p) {
        return new double[] {p[0], p[0] + p[2] / 3, p[1] + p[3] / 3, p[1]};
    }

    private static double value(double[] p, double u) {
        double v = 1 - u;
        return v * v * v * p[0] + 3 * u * v * v * p[1] + 3 * u * u * v * p[2] + u * u * u * p[3];
    }
}
