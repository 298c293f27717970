import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveFlattener;
import rasterlab.contract.CurvePoints;

public class MyPolyline implements CurveFlattener {
    @Override
    public void flatten(Curve curve, double flatness, CurvePoints out) {
        int d = curve.x().length - 1;
        double bend = 0;
        for (int i = 2; i <= d; i++) {
            double x = curve.x()[i] - 2 * curve.x()[i - 1] + curve.x()[i - 2];
            double y = curve.y()[i] - 2 * curve.y()[i - 1] + curve.y()[i - 2];
            bend = Math.max(bend, Math.sqrt(x * x + y * y));
        }
        int n = Math.max(1, (int) Math.ceil(Math.sqrt(d * (d - 1) * bend / (8 * flatness))));
        List<double[]> corners = new ArrayList<>();
        for (int k = 0; k <= n; k++) corners.add(at(curve, (double) k / n));
        for (int k = n; k >= 0; k--) out.point(corners.get(k)[0], corners.get(k)[1]);
    }

    private static double[] at(Curve curve, double t) {
        double[] x = curve.x().clone();
        double[] y = curve.y().clone();
        for (int row = x.length - 1; row > 0; row--)
            for (int i = 0; i < row; i++) {
                x[i] += t * (x[i + 1] - x[i]);
                y[i] += t * (y[i + 1] - y[i]);
            }
        return new double[] {x[0], y[0]};
    }
}
