import java.util.stream.IntStream;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveFlattener;
import rasterlab.contract.CurvePoints;

public class Generous implements CurveFlattener {
    record Point(double x, double y) {}

    // more corners than needed, from the length of the control polygon
    public void flatten(Curve curve, double flatness, CurvePoints out) {
        int d = curve.x().length - 1;
        double length =
                IntStream.range(0, d)
                        .mapToDouble(
                                i ->
                                        Math.hypot(
                                                curve.x()[i + 1] - curve.x()[i],
                                                curve.y()[i + 1] - curve.y()[i]))
                        .sum();
        int steps = (int) Math.max(1, Math.ceil(d * Math.sqrt(length / (4 * flatness))));
        IntStream.rangeClosed(0, steps)
                .mapToObj(k -> point(curve, (double) k / steps))
                .forEachOrdered(p -> out.point(p.x(), p.y()));
    }

    private static Point point(Curve curve, double t) {
        int d = curve.x().length - 1;
        double x = 0, y = 0, choose = 1;
        for (int i = 0; i <= d; i++) {
            double weight = choose * Math.pow(t, i) * Math.pow(1 - t, d - i);
            x += weight * curve.x()[i];
            y += weight * curve.y()[i];
            choose = choose * (d - i) / (i + 1);
        }
        return new Point(x, y);
    }
}
