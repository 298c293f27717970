package rasterlab.engine.polygon.triangle;

import rasterlab.engine.geometry.Orientation;

/**
 * The point seen from the three sides by exact {@link Orientation}s: inside where it is never on
 * the left of one side and on the right of another.
 *
 * <p>The three doubled areas o(a, b, p) + o(b, c, p) + o(c, a, p) add up to the triangle's own. So
 * where that is 0 and one of them is not, two differ in sign: outside. Where all three are 0, the
 * corners and the point lie on one line, and their extent decides.
 */
public final class RobustTriangle implements SideTests {
    @Override
    public int asked(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        int ab = Orientation.of(ax, ay, bx, by, x, y);
        int bc = Orientation.of(bx, by, cx, cy, x, y);
        if (ab * bc < 0) return -2;
        int ca = Orientation.of(cx, cy, ax, ay, x, y);
        if (ab * ca < 0 || bc * ca < 0) return -3;
        if ((ab | bc | ca) != 0) return 3;
        return within(ax, bx, cx, x) && within(ay, by, cy, y) ? 3 : -3;
    }

    /** Of the three questions, how many doubles alone cannot answer. */
    int hard(double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        int hard = 0;
        if (!Orientation.easy(ax, ay, bx, by, x, y)) hard++;
        if (!Orientation.easy(bx, by, cx, cy, x, y)) hard++;
        if (!Orientation.easy(cx, cy, ax, ay, x, y)) hard++;
        return hard;
    }

    private static boolean within(double a, double b, double c, double p) {
        return p >= Math.min(a, Math.min(b, c)) && p <= Math.max(a, Math.max(b, c));
    }

    @Override
    public int multiplicationsPerSide() {
        return 3;
    }

    @Override
    public int additionsPerSide() {
        return 7;
    }
}
