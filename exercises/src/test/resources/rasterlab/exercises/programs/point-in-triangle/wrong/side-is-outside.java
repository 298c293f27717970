import rasterlab.contract.PointInTriangle;

public class MyTriangle implements PointInTriangle {
    @Override
    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        double d1 = side(ax, ay, bx, by, x, y);
        double d2 = side(bx, by, cx, cy, x, y);
        double d3 = side(cx, cy, ax, ay, x, y);
        return d1 * d2 > 0 && d2 * d3 > 0;
    }

    private static double side(double px, double py, double qx, double qy, double x, double y) {
        return (qx - px) * (y - py) - (qy - py) * (x - px);
    }
}
