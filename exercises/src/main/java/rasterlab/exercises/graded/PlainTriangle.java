package rasterlab.exercises.graded;

import rasterlab.contract.PointInTriangle;

/**
 * Asks on which side of each edge the point lies: inside it is on none of two different sides.
 *
 * <p>Right wherever the products do not round, as for coordinates of up to 26 bits. Three corners
 * on a line leave no side, so then the point has to lie in their box too.
 */
public final class PlainTriangle implements PointInTriangle {
    @Override
    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        double ab = side(ax, ay, bx, by, x, y);
        double bc = side(bx, by, cx, cy, x, y);
        double ca = side(cx, cy, ax, ay, x, y);
        boolean apart = (ab > 0 || bc > 0 || ca > 0) && (ab < 0 || bc < 0 || ca < 0);
        return !apart && isBetween(ax, bx, cx, x) && isBetween(ay, by, cy, y);
    }

    private static double side(double x0, double y0, double x1, double y1, double x, double y) {
        return (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0);
    }

    private static boolean isBetween(double a, double b, double c, double value) {
        return value >= Math.min(a, Math.min(b, c)) && value <= Math.max(a, Math.max(b, c));
    }
}
