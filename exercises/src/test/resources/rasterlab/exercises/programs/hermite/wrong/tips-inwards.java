import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class AsBezier implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        double[] x = control(curve.x());
        double[] y = control(curve.y());
        for (double u : t) out.point(casteljau(x, u, 0, 3), casteljau(y, u, 0, 3));
    }

    private static double[] control(double[] h) {
        return new double[] {h[0], h[0] + (h[2] - h[0]) / 3, h[1] + (h[3] - h[1]) / 3, h[1]};
    }

    private static double casteljau(double[] p, double u, int from, int rows) {
        if (rows == 0) return p[from];
        return (1 - u) * casteljau(p, u, from, rows - 1) + u * casteljau(p, u, from + 1, rows - 1);
    }
}
