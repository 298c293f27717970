import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class Matrix implements CurveEvaluator {
    private static final double[][] M = {{2, -2, 1, 1}, {-3, 3, -2, -1}, {0, 0, 1, 0}, {1, 0, 0, 0}};

    public void at(Curve curve, double[] t, CurvePoints out) {
        double[] cx = times(curve.x());
        double[] cy = times(curve.y());
        DoubleStream.of(t).forEach(u -> out.point(horner(cx, u), horner(cy, u)));
    }

    private static double[] times(double[] g) {
        return IntStream.range(0, 4)
                .mapToDouble(r -> IntStream.range(0, 4).mapToDouble(c -> M[r][c] * g[c]).sum())
                .toArray();
    }

    private static double horner(double[] c, double u) {
        return DoubleStream.of(c).reduce(0, (sum, each) -> sum * u + each);
    }
}
