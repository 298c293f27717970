import rasterlab.contract.PointInTriangle;

public class SameSide implements PointInTriangle {
    @Override
    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        double a = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
        double b = (cx - bx) * (y - by) - (cy - by) * (x - bx);
        double c = (ax - cx) * (y - cy) - (ay - cy) * (x - cx);
        boolean negative = a < 0 || b < 0 || c < 0;
        boolean positive = a > 0 || b > 0 || c > 0;
        return !(negative && positive);
    }
}
