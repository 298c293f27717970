import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;

public class TextbookClip implements SegmentClipper {
    @Override
    public void clip(
            double xmin, double ymin, double xmax, double ymax,
            double x0, double y0, double x1, double y1, SegmentSink out) {
        double dx = x1 - x0;
        double dy = y1 - y0;
        double[] p = {-dx, dx, -dy, dy};
        double[] q = {x0 - xmin, xmax - x0, y0 - ymin, ymax - y0};
        double t0 = 0;
        double t1 = 1;
        for (int i = 0; i < 4; i++) {
            if (p[i] == 0) {
                if (q[i] < 0) return;
            } else if (p[i] < 0) t0 = Math.max(t0, q[i] / p[i]);
            else t1 = Math.min(t1, q[i] / p[i]);
        }
        if (t0 > t1) return;
        double ax = x0, ay = y0, bx = x1, by = y1;
        if (t0 > 0) {
            ax = x0 + t0 * dx;
            ay = y0 + t0 * dy;
        }
        if (t1 < 1) {
            bx = x0 + t1 * dx;
            by = y0 + t1 * dy;
        }
        out.segment(ax, ay, bx, by);
    }
}
