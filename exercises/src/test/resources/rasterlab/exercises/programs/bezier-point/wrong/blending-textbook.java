import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class Blending implements CurveEvaluator {
    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        for (double u : t) out.point(value(curve.x().clone(), u), value(curve.y().clone(), u));
    }

    private static double value(double[] p, double u) {
        if (p.length == 4)
            return (1 - u * u * u) * p[0]
                    + 3 * u * (u - 1) * (u - 1) * p[1]
                    + 3 * u * u * (1 - u) * p[2]
                    + u * u * u * p[3];
        for (int n = p.length - 1; n > 0; n--)
            for (int i = 0; i < n; i++) p[i] += u * (p[i + 1] - p[i]);
        return p[0];
    }
}
