import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

/** De Casteljau's triangle, each row in the place of the one above. */
public class Model implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        int n = curve.x().length;
        double[] x = new double[n];
        double[] y = new double[n];
        for (double u : t) {
            System.arraycopy(curve.x(), 0, x, 0, n);
            System.arraycopy(curve.y(), 0, y, 0, n);
            for (int row = n - 1; row > 0; row--)
                for (int i = 0; i < row; i++) {
                    x[i] = (1 - u) * x[i] + u * x[i + 1];
                    y[i] = (1 - u) * y[i] + u * y[i + 1];
                }
            out.point(x[0], y[0]);
        }
    }
}
