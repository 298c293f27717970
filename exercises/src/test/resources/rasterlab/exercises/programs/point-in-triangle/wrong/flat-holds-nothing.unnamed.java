import rasterlab.contract.*;

public class MyMethod implements PointInTriangle {

    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        double d = (by - cy) * (ax - cx) + (cx - bx) * (ay - cy);
        double a = (by - cy) * (x - cx) + (cx - bx) * (y - cy),
                b = (cy - ay) * (x - cx) + (ax - cx) * (y - cy),
                c = d - a - b;
        if (d == 0) return false;
        if (d < 0) {
            a = -a;
            b = -b;
            c = -c;
        }
        return a >= 0 && b >= 0 && c >= 0;
    }
}
