import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;

/** Asks each pixel of the picture, and sends each as a span of its own. */
public class CenterByCenter implements PolygonFiller {
    @Override
    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        double left = width, right = 0, top = height, bottom = 0;
        for (int i = 0; i < x.length; i++) {
            left = Math.min(left, x[i]);
            right = Math.max(right, x[i]);
            top = Math.min(top, y[i]);
            bottom = Math.max(bottom, y[i]);
        }
        for (int v = (int) Math.max(0, Math.floor(top)); v < height && v <= bottom; v++)
            for (int u = (int) Math.max(0, Math.floor(left)); u < width && u <= right; u++)
                if (rule.inside(winding(x, y, x.length - 1, u, v))) out.span(v, u, u + 1);
    }

    private static int winding(double[] x, double[] y, int i, int u, int v) {
        if (i < 0) return 0;
        int j = (i + 1) % x.length;
        int rest = winding(x, y, i - 1, u, v);
        if (y[i] <= v == y[j] <= v) return rest;
        double at = x[i] + (v - y[i]) * (x[j] - x[i]) / (y[j] - y[i]);
        return at > u ? rest : y[i] <= v ? rest + 1 : rest - 1;
    }
}
