import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class PointThenTangent implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        for (double u : t) out.point(mix(curve.x(), u), mix(curve.y(), u));
    }

    private double mix(double[] g, double u) {
        double start = g[0];
        double startTangent = g[1];
        double end = g[2];
        double endTangent = g[3];
        double u2 = u * u;
        double u3 = u2 * u;
        return start * (2 * u3 - 3 * u2 + 1)
                + startTangent * (u3 - 2 * u2 + u)
                + end * (3 * u2 - 2 * u3)
                + endTangent * (u3 - u2);
    }
}
