import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class Hermite implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        for (double u : t) out.point(value(curve.x(), u), value(curve.y(), u));
    }

    private double value(double[] p, double t) {
        double p0 = p[0];
        double r0 = p[1];
        double r1 = p[2];
        double p1 = p[3];
        double a = 2 * p0 - 2 * p1 + r0 + r1;
        double b = -3 * p0 + 3 * p1 - 2 * r0 - r1;
        return ((a * t + b) * t + r0) * t + p0;
    }
}
