import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

/** The four blending functions, each times what it blends. */
public class Model implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        double[] x = curve.x();
        double[] y = curve.y();
        for (double u : t) {
            double v = 1 - u;
            double start = v * v * (1 + 2 * u);
            double end = u * u * (1 + 2 * v);
            double leaving = u * v * v;
            double arriving = -u * u * v;
            out.point(
                    start * x[0] + end * x[1] + leaving * x[2] + arriving * x[3],
                    start * y[0] + end * y[1] + leaving * y[2] + arriving * y[3]);
        }
    }
}
