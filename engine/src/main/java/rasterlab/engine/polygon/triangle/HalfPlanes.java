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
final class HalfPlanes implements SideTests {
    @Override
    public int asked(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        SideTests.requireFinite(ax, ay, bx, by, cx, cy, x, y);
        if (beyond(ax, ay, bx, by, cx, cy, x, y)) return -1;
        if (beyond(bx, by, cx, cy, ax, ay, x, y)) return -2;
        if (beyond(cx, cy, ax, ay, bx, by, x, y)) return -3;
        return 3;
    }

    /** Whether (x, y) lies beyond the side p–q, seen from the third corner r. */
    private static boolean beyond(
            double px, double py, double qx, double qy, double rx, double ry, double x, double y) {
        double l = py - qy;
        double m = qx - px;
        double n = -(l * px + m * py);
        double f = l * x + m * y + n;
        return l * rx + m * ry + n > 0 ? f < 0 : f > 0;
    }

    @Override
    public int multiplicationsPerSide() {
        return 6;
    }

    @Override
    public int additionsPerSide() {
        return 7;
    }
}
