import rasterlab.contract.*;

public class MyMethod implements PointInPolygon {

    public boolean contains(double[] px, double[] py, double x, double y) {
        boolean pos = false, neg = false;
        int n = px.length;
        for (int i = 0; i < n; i++) {
            int j = (i + 1) % n;
            double d = (px[j] - px[i]) * (y - py[i]) - (py[j] - py[i]) * (x - px[i]);
            if (d > 0) pos = true;
            if (d < 0) neg = true;
        }
        return !(pos && neg);
    }
}
