import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;

public class EdgeTable implements PolygonFiller {
    record Edge(int first, int end, double x, double y, double slope, int direction) {
        double at(int row) {
            return x + (row - y) * slope;
        }
    }

    @Override
    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        List<Edge> edges = new ArrayList<>();
        for (int i = 0; i < x.length; i++) {
            int j = (i + 1) % x.length;
            int top = (int) Math.floor(Math.min(y[i], y[j]));
            int bottom = (int) Math.floor(Math.max(y[i], y[j]));
            if (top < bottom) edges.add(new Edge(top, bottom, x[i], y[i], (x[j] - x[i]) / (y[j] - y[i]), y[i] < y[j] ? 1 : -1));
        }
        for (int row = 0; row < height; row++) {
            int at = row;
            List<Edge> active = new ArrayList<>(edges);
            active.removeIf(edge -> at < edge.first() || at >= edge.end());
            active.sort((one, other) -> Double.compare(one.at(at), other.at(at)));
            int sum = 0;
            double left = 0;
            for (Edge edge : active) {
                boolean before = rule.inside(sum);
                sum += edge.direction();
                if (!before && rule.inside(sum)) left = edge.at(row);
                if (!before || rule.inside(sum)) continue;
                int from = Math.max(0, (int) Math.floor(left));
                int to = Math.min(width, (int) Math.floor(edge.at(row)));
                if (from < to) out.span(row, from, to);
            }
        }
    }
}
