import rasterlab.contract.Curve;
import rasterlab.contract.CurveFlattener;
import rasterlab.contract.CurvePoints;

public class Halving implements CurveFlattener {
    @Override
    public void flatten(Curve curve, double flatness, CurvePoints out) {
        out.point(curve.x()[0], curve.y()[0]);
        halve(curve.x().clone(), curve.y().clone(), flatness, 30, out);
    }

    private void halve(double[] x, double[] y, double flatness, int depth, CurvePoints out) {
        int last = x.length - 1;
        if (depth == 0 || isFlat(x, y, flatness)) {
            out.point(x[last], y[last]);
            return;
        }
        double[] leftX = new double[last + 1], leftY = new double[last + 1];
        for (int row = last; row >= 0; row--) {
            leftX[last - row] = x[0];
            leftY[last - row] = y[0];
            for (int i = 0; i < row; i++) {
                x[i] = x[i] / 2 + x[i + 1] / 2;
                y[i] = y[i] / 2 + y[i + 1] / 2;
            }
        }
        halve(leftX, leftY, flatness, depth - 1, out);
        halve(x, y, flatness, depth - 1, out);
    }

    /** All control points near the segment: the curve lies in their hull. */
    private static boolean isFlat(double[] x, double[] y, double flatness) {
        int last = x.length - 1;
        double dx = x[last] - x[0], dy = y[last] - y[0];
        double square = dx * dx + dy * dy;
        for (int i = 1; i < last; i++) {
            double along = (x[i] - x[0]) * dx + (y[i] - y[0]) * dy;
            double share = square > 0 ? Math.min(1, Math.max(0, along / square)) : 0;
            double off = Math.hypot(x[i] - x[0] - share * dx, y[i] - y[0] - share * dy);
            if (off > flatness) return false;
        }
        return true;
    }
}
