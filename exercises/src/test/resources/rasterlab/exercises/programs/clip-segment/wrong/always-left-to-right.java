import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;

public class LeftToRight implements SegmentClipper {
    @Override
    public void clip(
            double xmin, double ymin, double xmax, double ymax,
            double x0, double y0, double x1, double y1, SegmentSink out) {
        if (x0 > x1) {
            clip(xmin, ymin, xmax, ymax, x1, y1, x0, y0, out);
            return;
        }
        double dx = x1 - x0, dy = y1 - y0, in = 0, leave = 1;
        double[] p = {-dx, dx, -dy, dy};
        double[] q = {x0 - xmin, xmax - x0, y0 - ymin, ymax - y0};
        for (int i = 0; i < 4; i++) {
            if (p[i] == 0 && q[i] < 0) return;
            if (p[i] < 0) in = Math.max(in, q[i] / p[i]);
            if (p[i] > 0) leave = Math.min(leave, q[i] / p[i]);
        }
        if (in > leave) return;
        double ax = in > 0 ? x0 + in * dx : x0, ay = in > 0 ? y0 + in * dy : y0;
        double bx = leave < 1 ? x0 + leave * dx : x1, by = leave < 1 ? y0 + leave * dy : y1;
        out.segment(within(xmin, ax, xmax), within(ymin, ay, ymax), within(xmin, bx, xmax), within(ymin, by, ymax));
    }

    private static double within(double least, double value, double most) {
        return Math.max(least, Math.min(most, value));
    }
}
