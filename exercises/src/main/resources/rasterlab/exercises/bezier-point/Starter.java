import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

/** Computes points of a Bézier curve. So far it sends none. */
public class MyBezier implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {}
}
