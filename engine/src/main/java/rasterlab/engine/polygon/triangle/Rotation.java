package rasterlab.engine.polygon.triangle;

/**
 * Turns the plane about the point until a corner lies on the Oy axis; inside where the two other
 * corners then have x of different signs, for each corner in turn.
 *
 * <p>The corner at distance r and angle t from Oy, sin t = vx/r, is turned by t: {@code x' = x·cos
 * t − y·sin t}, {@code y' = x·sin t + y·cos t}. A corner with x' = 0 is on the axis too; the point
 * is on that side where the two have y of different signs.
 *
 * <p>sin and cos are rounded, so x' is hardly ever exactly 0, and a point on a side falls to
 * either.
 */
final class Rotation implements SideTests {
    @Override
    public int asked(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        SideTests.requireFinite(ax, ay, bx, by, cx, cy, x, y);
        if (sameSide(ax - x, ay - y, bx - x, by - y, cx - x, cy - y)) return -1;
        if (sameSide(bx - x, by - y, cx - x, cy - y, ax - x, ay - y)) return -2;
        if (sameSide(cx - x, cy - y, ax - x, ay - y, bx - x, by - y)) return -3;
        return 3;
    }

    /** Whether, with v turned onto the Oy axis, p and q lie on one side of it. */
    private static boolean sameSide(
            double vx, double vy, double px, double py, double qx, double qy) {
        double angle = StrictMath.atan2(vx, vy);
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        double vTurned = vx * sin + vy * cos;
        double pTurned = px * cos - py * sin;
        double qTurned = qx * cos - qy * sin;
        if (pTurned == 0) return (px * sin + py * cos) * vTurned > 0;
        if (qTurned == 0) return (qx * sin + qy * cos) * vTurned > 0;
        return pTurned > 0 == qTurned > 0;
    }

    @Override
    public int multiplicationsPerSide() {
        return 6;
    }

    @Override
    public int additionsPerSide() {
        return 9;
    }
}
