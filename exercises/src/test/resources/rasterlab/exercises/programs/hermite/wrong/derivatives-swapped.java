import rasterlab.contract.*;

public class MyMethod implements CurveEvaluator {

    public void at(Curve c, double[] t, CurvePoints out) {
        for (double u : t) {
            double u2 = u * u,
                    u3 = u2 * u,
                    a = 2 * u3 - 3 * u2 + 1,
                    b = 3 * u2 - 2 * u3,
                    d = u3 - 2 * u2 + u,
                    e = u3 - u2;
            out.point(
                    a * c.x()[0] + b * c.x()[1] + d * c.x()[3] + e * c.x()[2],
                    a * c.y()[0] + b * c.y()[1] + d * c.y()[3] + e * c.y()[2]);
        }
    }
}
