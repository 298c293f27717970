import rasterlab.contract.*;

public class MyMethod implements PolygonFiller {

    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        int[][] d = new int[height][width + 1];
        for (int i = 0, j = x.length - 1; i < x.length; j = i++) {
            if (y[i] == y[j]) continue;
            int dir = y[i] > y[j] ? 1 : -1;
            double lo = Math.min(y[i], y[j]), hi = Math.max(y[i], y[j]);
            for (int r = (int) Math.max(0, Math.ceil(lo)); r < height && r < hi; r++) {
                double X = x[j] + (r - y[j]) * (x[i] - x[j]) / (y[i] - y[j]);
                int c = (int) Math.max(0, Math.min(width, Math.ceil(X)));
                d[r][c] += 1;
            }
        }
        for (int r = 0; r < height; r++) {
            int s = 0, from = -1;
            for (int c = 0; c <= width; c++) {
                if (c < width) s += d[r][c];
                boolean in = c < width && rule.inside(s);
                if (in && from < 0) from = c;
                if (!in && from >= 0) {
                    out.span(r, from, c);
                    from = -1;
                }
            }
        }
    }
}
