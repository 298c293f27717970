import java.util.TreeMap;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;

public class MyFill implements PolygonFiller {
    @Override
    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        for (int row = 0; row < height; row++) {
            var crossings = new TreeMap<Double, Integer>();
            for (int i = 0; i < x.length; i++) {
                int j = (i + 1) % x.length;
                if (y[i] <= row == y[j] <= row) continue;
                double at = x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]);
                crossings.merge(at, y[i] <= row ? 1 : -1, Integer::sum);
            }
            int sum = 0;
            double left = 0;
            for (var one : crossings.entrySet()) {
                boolean before = rule.inside(sum);
                sum += one.getValue();
                if (!before && rule.inside(sum)) left = one.getKey();
                if (!before || rule.inside(sum)) continue;
                int from = Math.max(0, (int) Math.floor(left));
                int to = Math.min(width, (int) Math.floor(one.getKey()));
                if (from < to) out.span(row, from, to);
            }
        }
    }
}
