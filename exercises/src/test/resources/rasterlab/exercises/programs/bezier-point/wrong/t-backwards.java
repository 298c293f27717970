import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class Casteljau implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        for (double u : t) {
            double[] x = curve.x().clone();
            double[] y = curve.y().clone();
            for (int n = x.length - 1; n > 0; n--)
                for (int i = 0; i < n; i++) {
                    x[i] = u * x[i] + (1 - u) * x[i + 1];
                    y[i] = u * y[i] + (1 - u) * y[i + 1];
                }
            out.point(x[0], y[0]);
        }
    }
}
