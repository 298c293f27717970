import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class Backwards implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        double[] x = curve.x();
        double[] y = curve.y();
        for (double each : t) {
            double u = 1 - each;
            double end = u * u * (3 - 2 * u);
            double leaving = u * (u - 1) * (u - 1);
            double arriving = u * u * (u - 1);
            out.point(
                    (1 - end) * x[0] + end * x[1] + leaving * x[2] + arriving * x[3],
                    (1 - end) * y[0] + end * y[1] + leaving * y[2] + arriving * y[3]);
        }
    }
}
