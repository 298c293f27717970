import rasterlab.contract.PointInTriangle;

public class Barycentric implements PointInTriangle {
    record Vector(double x, double y) {
        Vector minus(Vector o) {
            return new Vector(x - o.x, y - o.y);
        }

        double cross(Vector o) {
            return x * o.y - y * o.x;
        }
    }

    @Override
    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        Vector a = new Vector(ax, ay);
        Vector u = new Vector(bx, by).minus(a);
        Vector v = new Vector(cx, cy).minus(a);
        Vector p = new Vector(x, y).minus(a);
        double whole = u.cross(v);
        double s = p.cross(v) * Math.signum(whole);
        double t = u.cross(p) * Math.signum(whole);
        return t >= 0 && s + t <= Math.abs(whole);
    }
}
