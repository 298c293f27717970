import rasterlab.contract.*;

public class MyMethod implements PointInTriangle {

    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        return x >= Math.min(ax, Math.min(bx, cx))
                && x <= Math.max(ax, Math.max(bx, cx))
                && y >= Math.min(ay, Math.min(by, cy))
                && y <= Math.max(ay, Math.max(by, cy));
    }
}
