import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;

public class StreamFill implements PolygonFiller {
    record Crossing(double x, int direction) {}

    record Edge(double x0, double y0, double x1, double y1) {
        boolean crosses(int row) {
            return y0 <= row != y1 <= row;
        }

        Crossing crossing(int row) {
            double t = (row - y0) / (y1 - y0);
            return new Crossing(x0 + (x1 - x0) * t, y1 > y0 ? 1 : -1);
        }
    }

    @Override
    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        int n = x.length;
        List<Edge> edges =
                IntStream.range(0, n)
                        .mapToObj(i -> new Edge(x[i], y[i], x[(i + 1) % n], y[(i + 1) % n]))
                        .toList();
        for (int row = 0; row < height; row++) fill(row, edges, rule, width, out);
    }

    private static void fill(int row, List<Edge> edges, FillRule rule, int width, Spans out) {
        List<Crossing> crossings =
                edges.stream()
                        .filter(edge -> edge.crosses(row))
                        .map(edge -> edge.crossing(row))
                        .sorted(Comparator.comparingDouble(Crossing::x))
                        .toList();
        int sum = 0;
        for (int k = 0; k + 1 < crossings.size(); k++) {
            sum += crossings.get(k).direction();
            int from = (int) Math.max(0, Math.ceil(crossings.get(k).x()));
            int to = (int) Math.min(width, Math.ceil(crossings.get(k + 1).x()));
            if (rule.inside(sum) && from < to) out.span(row, from, to);
        }
    }
}
