import rasterlab.contract.*;

public class MyMethod implements SegmentClipper {

    public void clip(
            double xmin,
            double ymin,
            double xmax,
            double ymax,
            double x0,
            double y0,
            double x1,
            double y1,
            SegmentSink out) {
        if (!in(x0, y0, xmin, ymin, xmax, ymax) && !in(x1, y1, xmin, ymin, xmax, ymax)) return;
        double dx = x1 - x0, dy = y1 - y0, t0 = 0, t1 = 1;
        double[] p = {-dx, dx, -dy, dy}, q = {x0 - xmin, xmax - x0, y0 - ymin, ymax - y0};
        for (int i = 0; i < 4; i++) {
            if (p[i] == 0) {
                if (q[i] < 0) return;
                continue;
            }
            double t = q[i] / p[i];
            if (p[i] < 0) t0 = Math.max(t0, t);
            else t1 = Math.min(t1, t);
        }
        if (t0 > t1) return;
        out.segment(
                t0 == 0 ? x0 : x0 + t0 * dx,
                t0 == 0 ? y0 : y0 + t0 * dy,
                t1 == 1 ? x1 : x0 + t1 * dx,
                t1 == 1 ? y1 : y0 + t1 * dy);
    }

    static boolean in(double x, double y, double a, double b, double c, double d) {
        return x >= a && x <= c && y >= b && y <= d;
    }
}
