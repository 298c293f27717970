import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;

public class RecursiveCodes implements SegmentClipper {
    record Point(double x, double y) {}

    record Window(double left, double low, double right, double high) {
        int code(Point p) {
            int code = p.x < left ? 1 : p.x > right ? 2 : 0;
            return code + (p.y < low ? 4 : p.y > high ? 8 : 0);
        }
    }

    @Override
    public void clip(
            double xmin, double ymin, double xmax, double ymax,
            double x0, double y0, double x1, double y1, SegmentSink out) {
        clip(new Window(xmin, ymin, xmax, ymax), new Point(x0, y0), new Point(x1, y1), out);
    }

    private static void clip(Window w, Point a, Point b, SegmentSink out) {
        int codeA = w.code(a);
        int codeB = w.code(b);
        if ((codeA & codeB) != 0) return;
        if (codeA != 0) clip(w, cut(w, a, b, codeA), b, out);
        else if (codeB != 0) clip(w, a, cut(w, a, b, codeB), out);
        else out.segment(a.x, a.y, b.x, b.y);
    }

    private static Point cut(Window w, Point a, Point b, int code) {
        if ((code & 3) != 0) {
            double x = (code & 1) != 0 ? w.left : w.right;
            return new Point(x, b.y + (x - a.x) * (b.y - a.y) / (b.x - a.x));
        }
        double y = (code & 4) != 0 ? w.low : w.high;
        return new Point(a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y), y);
    }
}
