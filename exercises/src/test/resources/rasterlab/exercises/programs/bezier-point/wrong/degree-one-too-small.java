import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class Bernstein implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        int n = curve.x().length - 1;
        double[] choose = new double[n + 1];
        choose[0] = 1;
        for (int i = 1; i <= n; i++) choose[i] = choose[i - 1] * (n - i + 1) / i;
        for (int k = 0; k < t.length; k++) {
            double x = 0;
            double y = 0;
            for (int i = 0; i <= n; i++) {
                double weight = choose[i] * Math.pow(t[k], i) * Math.pow(1 - t[k], n - i - 1);
                x += weight * curve.x()[i];
                y += weight * curve.y()[i];
            }
            out.point(x, y);
        }
    }
}
