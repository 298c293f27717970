import java.util.Arrays;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;

/** Sorts the crossings of each row and adds up the directions from left to right. */
public class Model implements PolygonFiller {
    @Override
    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        long[] crossings = new long[x.length];
        for (int row = 0; row < height; row++) {
            int count = 0;
            for (int i = 0; i < x.length; i++) {
                int j = i + 1 == x.length ? 0 : i + 1;
                if (y[i] <= row == y[j] <= row) continue;
                double at = x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]);
                long column = (long) Math.ceil(Math.max(0, Math.min(width, at)));
                crossings[count++] = 2 * column + (y[i] < y[j] ? 1 : 0);
            }
            Arrays.sort(crossings, 0, count);
            int winding = 0;
            int from = 0;
            for (int k = 0; k < count; k++) {
                int column = (int) (crossings[k] / 2);
                if (from < column && rule.inside(winding)) out.span(row, from, column);
                from = column;
                winding += crossings[k] % 2 == 1 ? 1 : -1;
            }
        }
    }
}
