import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;

public class Clamp implements SegmentClipper {
    @Override
    public void clip(
            double xmin, double ymin, double xmax, double ymax,
            double x0, double y0, double x1, double y1, SegmentSink out) {
        double ax = Math.min(xmax, Math.max(xmin, x0));
        double ay = Math.min(ymax, Math.max(ymin, y0));
        double bx = Math.min(xmax, Math.max(xmin, x1));
        double by = Math.min(ymax, Math.max(ymin, y1));
        out.segment(ax, ay, bx, by);
    }
}
