import rasterlab.contract.*;

public class MyMethod implements PointInTriangle {

    static double s(double px, double py, double qx, double qy, double x, double y) {
        return (qx - px) * (y - py) - (qy - py) * (x - px);
    }

    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        double d1 = s(ax, ay, bx, by, x, y),
                d2 = s(bx, by, cx, cy, x, y),
                d3 = s(cx, cy, ax, ay, x, y);
        boolean neg = d1 < 0 || d2 < 0, pos = d1 > 0 || d2 > 0;
        if (d1 == 0 && d2 == 0)
            return x >= Math.min(ax, Math.min(bx, cx))
                    && x <= Math.max(ax, Math.max(bx, cx))
                    && y >= Math.min(ay, Math.min(by, cy))
                    && y <= Math.max(ay, Math.max(by, cy));
        return !(neg && pos);
    }
}
