import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

/** Computes points of a Hermite curve. So far it sends none. */
public class MyHermite implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {}
}
