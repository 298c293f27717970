import rasterlab.contract.PointInTriangle;

/** Tells whether a point lies in a triangle. So far it is never inside. */
public class MyTriangle implements PointInTriangle {
    @Override
    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        return false;
    }
}
