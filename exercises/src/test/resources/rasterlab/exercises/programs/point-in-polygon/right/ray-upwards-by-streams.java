import java.util.stream.IntStream;
import rasterlab.contract.PointInPolygon;

public class Upwards implements PointInPolygon {
    record Edge(double x0, double y0, double x1, double y1) {
        boolean has(double x, double y) {
            boolean onLine = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) == 0;
            return onLine && (x - x0) * (x - x1) <= 0 && (y - y0) * (y - y1) <= 0;
        }

        boolean above(double x, double y) {
            return x0 > x != x1 > x && y < y0 + (x - x0) * (y1 - y0) / (x1 - x0);
        }
    }

    @Override
    public boolean contains(double[] px, double[] py, double x, double y) {
        int n = px.length;
        var edges =
                IntStream.range(0, n)
                        .mapToObj(i -> new Edge(px[i], py[i], px[(i + 1) % n], py[(i + 1) % n]))
                        .toList();
        return edges.stream().anyMatch(edge -> edge.has(x, y))
                || edges.stream().filter(edge -> edge.above(x, y)).count() % 2 == 1;
    }
}
