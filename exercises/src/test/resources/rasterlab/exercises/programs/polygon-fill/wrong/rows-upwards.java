import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;

public class UpFill implements PolygonFiller {
    @Override
    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        for (int row = height - 1; row >= 0; row--) {
            int[] change = new int[width + 1];
            for (int i = 0; i < x.length; i++) {
                int j = i + 1 < x.length ? i + 1 : 0;
                if (y[i] <= row == y[j] <= row) continue;
                double at = Math.ceil(x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]));
                change[(int) Math.max(0, Math.min(width, at))] += y[i] <= row ? 1 : -1;
            }
            int sum = 0;
            int from = -1;
            for (int column = 0; column <= width; column++) {
                sum += change[column];
                boolean inside = column < width && rule.inside(sum);
                if (inside && from < 0) from = column;
                if (!inside && from >= 0) {
                    out.span(row, from, column);
                    from = -1;
                }
            }
        }
    }
}
