import rasterlab.contract.*;

public class MyMethod implements PointInPolygon {

    public boolean contains(double[] px, double[] py, double x, double y) {
        boolean in = false;
        int n = px.length;
        for (int i = 0, j = n - 1; i < n; j = i++) {
            double x0 = px[j], y0 = py[j], x1 = px[i], y1 = py[i];
            if ((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) == 0
                    && x >= Math.min(x0, x1)
                    && x <= Math.max(x0, x1)
                    && y >= Math.min(y0, y1)
                    && y <= Math.max(y0, y1)) return false;
            if ((y0 > y) != (y1 > y) && x < x0 + (y - y0) * (x1 - x0) / (y1 - y0)) in = !in;
        }
        return in;
    }
}
