import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;

public class LiangBarsky implements SegmentClipper {
    private double in;
    private double leave;

    @Override
    public void clip(
            double xmin, double ymin, double xmax, double ymax,
            double x0, double y0, double x1, double y1, SegmentSink out) {
        double dx = x1 - x0;
        double dy = y1 - y0;
        in = 0;
        leave = 1;
        if (!half(-dx, x0 - xmin) || !half(dx, xmax - x0)) return;
        if (!half(-dy, y0 - ymin) || !half(dy, ymax - y0)) return;
        if (in >= leave) return;
        double ax = in > 0 ? x0 + in * dx : x0, ay = in > 0 ? y0 + in * dy : y0;
        double bx = leave < 1 ? x0 + leave * dx : x1, by = leave < 1 ? y0 + leave * dy : y1;
        out.segment(within(xmin, ax, xmax), within(ymin, ay, ymax), within(xmin, bx, xmax), within(ymin, by, ymax));
    }

    private boolean half(double p, double q) {
        if (p == 0) return q >= 0;
        if (p < 0) in = Math.max(in, q / p);
        else leave = Math.min(leave, q / p);
        return true;
    }

    private static double within(double least, double value, double most) {
        return Math.max(least, Math.min(most, value));
    }
}
