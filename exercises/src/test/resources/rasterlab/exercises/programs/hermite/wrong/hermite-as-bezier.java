import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class Points implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        for (double u : t) out.point(value(curve.x(), u), value(curve.y(), u));
    }

    private static double value(double[] p, double u) {
        double v = 1 - u;
        return v * v * v * p[0] + 3 * u * v * v * p[1] + 3 * u * u * v * p[2] + u * u * u * p[3];
    }
}
