import rasterlab.contract.Curve;
import rasterlab.contract.CurveFlattener;
import rasterlab.contract.CurvePoints;

/** Equal steps, so many that the second derivative cannot bend the curve farther off. */
public class Model implements CurveFlattener {
    @Override
    public void flatten(Curve curve, double flatness, CurvePoints out) {
        double[] px = curve.x();
        double[] py = curve.y();
        int degree = px.length - 1;
        double bend = 0;
        for (int i = 0; i + 2 <= degree; i++)
            bend =
                    Math.max(
                            bend,
                            Math.hypot(
                                    px[i + 2] - 2 * px[i + 1] + px[i],
                                    py[i + 2] - 2 * py[i + 1] + py[i]));
        double count = Math.ceil(Math.sqrt(degree * (degree - 1) * (bend / (8 * flatness))));
        int steps = Math.max(1, (int) count);
        double[] x = new double[px.length];
        double[] y = new double[px.length];
        for (int k = 0; k <= steps; k++) {
            double t = (double) k / steps;
            System.arraycopy(px, 0, x, 0, px.length);
            System.arraycopy(py, 0, y, 0, py.length);
            for (int row = degree; row > 0; row--)
                for (int i = 0; i < row; i++) {
                    x[i] = (1 - t) * x[i] + t * x[i + 1];
                    y[i] = (1 - t) * y[i] + t * y[i + 1];
                }
            out.point(x[0], y[0]);
        }
    }
}
