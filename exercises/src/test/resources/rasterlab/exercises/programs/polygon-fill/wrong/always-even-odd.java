import java.util.ArrayList;
import java.util.Collections;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;

public class ScanFill implements PolygonFiller {
    @Override
    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        for (int row = 0; row < height; row++) {
            var at = new ArrayList<Double>();
            for (int i = 0, j = x.length - 1; i < x.length; j = i++)
                if (y[i] <= row != y[j] <= row) at.add(x[j] + (row - y[j]) * (x[i] - x[j]) / (y[i] - y[j]));
            Collections.sort(at);
            for (int k = 0; k + 1 < at.size(); k += 2) {
                int from = (int) Math.max(0, Math.ceil(at.get(k)));
                int to = (int) Math.min(width, Math.ceil(at.get(k + 1)));
                if (from < to) out.span(row, from, to);
            }
        }
    }
}
