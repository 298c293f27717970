import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveEvaluator;
import rasterlab.contract.CurvePoints;

public class Recursive implements CurveEvaluator {
    record Point(double x, double y) {
        Point towards(Point other, double t) {
            return new Point(x + t * (other.x - x), y + t * (other.y - y));
        }
    }

    static Point reduced(List<Point> row, double t) {
        if (row.size() == 1) return row.get(0);
        return reduced(
                IntStream.range(1, row.size())
                        .mapToObj(i -> row.get(i - 1).towards(row.get(i), t))
                        .toList(),
                t);
    }

    public void at(Curve curve, double[] t, CurvePoints out) {
        List<Point> points =
                IntStream.range(0, curve.x().length)
                        .mapToObj(i -> new Point(curve.x()[i], curve.y()[i]))
                        .toList();
        DoubleStream.of(t)
                .mapToObj(u -> reduced(points, u))
                .forEachOrdered(p -> out.point(p.x(), p.y()));
    }
}
