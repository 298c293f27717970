package rasterlab.engine.polygon.triangle;

/**
 * Three signed half-planes: inside where no side's function is positive.
 *
 * <p>The side from p to q is the line {@code f(x, y) = L·x + M·y + N}, L = py − qy, M = qx − px, N
 * = −(L·px + M·py). If the third corner has f &gt; 0, L, M and N are negated, so that the triangle
 * lies where f ≤ 0.
 *
 * <p>N is a sum of products and rounded, so points within a few ulps of a side fall to either.
 * Corners on one line give f = 0 along all of it, also beyond the ends.
 */
final class HalfPlanes implements SteppedTriangleTest {
    @Override
    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        return new Walk(ax, ay, bx, by, cx, cy, x, y).drain();
    }

    @Override
    public SideWalk walk(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        return new Walk(ax, ay, bx, by, cx, cy, x, y);
    }

    @Override
    public String valueFormula() {
        return "f of the point, its sign turned where the third corner has f > 0; inside where none is"
                + " positive";
    }

    private static final class Walk extends SideWalk {
        Walk(double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
            super(ax, ay, bx, by, cx, cy, x, y);
        }

        @Override
        double ask(int side) {
            return switch (side) {
                case 0 -> side(ax, ay, bx, by, cx, cy);
                case 1 -> side(bx, by, cx, cy, ax, ay);
                default -> side(cx, cy, ax, ay, bx, by);
            };
        }

        /** f of the point for the side p–q, turned so that the third corner r has f ≤ 0. */
        private double side(double px, double py, double qx, double qy, double rx, double ry) {
            spend(6, 7);
            double l = py - qy;
            double m = qx - px;
            double n = -(l * px + m * py);
            double f = l * x + m * y + n;
            return l * rx + m * ry + n > 0 ? -f : f;
        }

        @Override
        boolean outside(int side, double value) {
            return value > 0;
        }
    }
}
