import rasterlab.contract.*;

import java.util.*;

public class MyMethod implements PolygonFiller {

    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        int n = x.length;
        for (int row = 0; row < height; row++) {
            List<double[]> cross = new ArrayList<>();
            for (int i = 0; i < n - 1; i++) {
                int j = (i + 1) % n;
                if ((y[i] <= row) != (y[j] <= row))
                    cross.add(
                            new double[] {
                                x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]),
                                y[j] > y[i] ? 1 : -1
                            });
            }
            cross.sort(Comparator.comparingDouble(c -> c[0]));
            int sum = 0;
            for (int k = 0; k + 1 < cross.size(); k++) {
                sum += (int) cross.get(k)[1];
                if (!rule.inside(sum)) continue;
                int from = (int) Math.max(0, Math.ceil(cross.get(k)[0])),
                        to = (int) Math.min(width, Math.ceil(cross.get(k + 1)[0]));
                if (from < to) out.span(row, from, to);
            }
        }
    }
}
