package rasterlab.engine.polygon.triangle;

/**
 * Träger's sign method in double: inside where three cross products have equal sign bits.
 *
 * <p>{@code side(p, q) = (y − py)·(qx − px) − (x − px)·(qy − py)}, for the sides a–c, c–b and b–a,
 * compared by the exclusive or of their bits as in {@link SignInt}.
 *
 * <p>−0.0 has its sign bit set, so a point on a side may count as beyond it, whichever way round
 * the corners go; near a side the products' rounding decides. Three zeros agree, so of corners on
 * one line the whole line is inside.
 */
final class SignDouble implements SideTests {
    @Override
    public int asked(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        SideTests.requireFinite(ax, ay, bx, by, cx, cy, x, y);
        double first = (y - ay) * (cx - ax) - (x - ax) * (cy - ay);
        double second = (y - cy) * (bx - cx) - (x - cx) * (by - cy);
        if (differ(first, second)) return -2;
        double third = (y - by) * (ax - bx) - (x - bx) * (ay - by);
        return differ(first, third) ? -3 : 3;
    }

    /** Whether the sign bits differ; −0 has one, 0 and, on every machine so read, NaN have none. */
    private static boolean differ(double a, double b) {
        return (Double.doubleToLongBits(a) ^ Double.doubleToLongBits(b)) < 0;
    }

    @Override
    public int multiplicationsPerSide() {
        return 2;
    }

    @Override
    public int additionsPerSide() {
        return 5;
    }
}
