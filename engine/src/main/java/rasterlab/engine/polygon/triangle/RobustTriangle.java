package rasterlab.engine.polygon.triangle;

import rasterlab.engine.geometry.Orientation;

/**
 * Trager's sign method without its failures: doubles where their signs are certain, exact {@link
 * Orientation}s where not.
 *
 * <p>Each side has {@code s = (qx − px)·y − (qy − py)·x + c}, c = (qy − py)·px − (qx − px)·py. With
 * E the sum of the sizes of all sides' differences and F = |ax| + |ay| + E, no |p| or c/E exceeds
 * F, so each s is off by less than {@code 8·2⁻⁵³·E·(|x| + |y| + F)}, to which {@link #UNDERFLOW}
 * adds what products near zero can lose. Where all three sizes exceed that, none is 0 and equal
 * sign bits mean inside. It costs no jump that depends on the point.
 *
 * <p>A side's own differences are at most half of E, so a product or sum on the way overflows only
 * where {@code E·(|x| + |y| + F)} does too. Multiplied out before the small factor, that makes the
 * bound infinite, which no size exceeds.
 *
 * <p>Otherwise inside is what is never on the left of one side and on the right of another, seen
 * exactly. The three doubled areas add up to the triangle's own, so where that is 0 and one of them
 * is not, two differ in sign: outside. Where all three are 0, corners and point lie on one line,
 * and their extent decides.
 *
 * <p>A walk asks side after side exactly, and so answers what {@code contains} does: doubles only
 * spare the exact signs.
 *
 * <p>Source: exact signs after J. R. Shewchuk, Adaptive precision floating-point arithmetic and
 * fast robust geometric predicates, Discrete & Computational Geometry 18, 1997, pp. 305–363.
 */
public final class RobustTriangle implements SteppedTriangleTest {
    private static final double ROUNDING = 8 * 0x1p-53;
    private static final double UNDERFLOW = 0x1p-1060;

    /** Products of differences: 4 per side; and 2 for the bound. */
    static final long MULTIPLICATIONS = 14;

    /** 6 differences, 3 additions per side, 7 for E and F, 3 for the bound. */
    static final long ADDITIONS = 25;

    private final Runnable onExact;

    public RobustTriangle() {
        this(() -> {});
    }

    /**
     * @param onExact run for each side that is asked exactly
     */
    RobustTriangle(Runnable onExact) {
        this.onExact = onExact;
    }

    @Override
    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        double abx = bx - ax;
        double aby = by - ay;
        double bcx = cx - bx;
        double bcy = cy - by;
        double cax = ax - cx;
        double cay = ay - cy;
        double ab = Math.fma(abx, y, Math.fma(-aby, x, aby * ax - abx * ay));
        double bc = Math.fma(bcx, y, Math.fma(-bcy, x, bcy * bx - bcx * by));
        double ca = Math.fma(cax, y, Math.fma(-cay, x, cay * cx - cax * cy));
        double e =
                Math.abs(abx)
                        + Math.abs(aby)
                        + Math.abs(bcx)
                        + Math.abs(bcy)
                        + Math.abs(cax)
                        + Math.abs(cay);
        double f = Math.abs(ax) + Math.abs(ay) + e;
        double scale = e * (Math.abs(x) + Math.abs(y) + f);
        double bound = ROUNDING * scale + UNDERFLOW;
        if (Math.abs(ab) > bound && Math.abs(bc) > bound && Math.abs(ca) > bound) {
            long bits = Double.doubleToRawLongBits(ab);
            return ((bits ^ Double.doubleToRawLongBits(bc))
                            | (bits ^ Double.doubleToRawLongBits(ca)))
                    >= 0;
        }
        return exactly(ax, ay, bx, by, cx, cy, x, y);
    }

    @Override
    public SideWalk walk(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        return new Walk(ax, ay, bx, by, cx, cy, x, y);
    }

    @Override
    public String valueFormula() {
        return "exact sign of (qx − px)·(y − py) − (qy − py)·(x − px) for the sides a–b, b–c, c–a;"
                + " outside as soon as two are opposite";
    }

    private static final class Walk extends SideWalk {
        private boolean left;
        private boolean right;

        Walk(double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
            super(ax, ay, bx, by, cx, cy, x, y);
        }

        @Override
        double ask(int side) {
            return switch (side) {
                case 0 -> Orientation.of(ax, ay, bx, by, x, y);
                case 1 -> Orientation.of(bx, by, cx, cy, x, y);
                default -> Orientation.of(cx, cy, ax, ay, x, y);
            };
        }

        @Override
        boolean outside(int side, double value) {
            left |= value > 0;
            right |= value < 0;
            if (left && right) return true;
            boolean onOneLine = side == 2 && !left && !right;
            return onOneLine && !(within(ax, bx, cx, x) && within(ay, by, cy, y));
        }
    }

    private boolean exactly(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        SideWalk.requireFinite(ax, ay, bx, by, cx, cy, x, y);
        int ab = exactSide(ax, ay, bx, by, x, y);
        int bc = exactSide(bx, by, cx, cy, x, y);
        int ca = exactSide(cx, cy, ax, ay, x, y);
        if (ab * bc < 0 || ab * ca < 0 || bc * ca < 0) return false;
        if ((ab | bc | ca) != 0) return true;
        return within(ax, bx, cx, x) && within(ay, by, cy, y);
    }

    private int exactSide(double px, double py, double qx, double qy, double x, double y) {
        onExact.run();
        return Orientation.of(px, py, qx, qy, x, y);
    }

    private static boolean within(double a, double b, double c, double p) {
        return p >= Math.min(a, Math.min(b, c)) && p <= Math.max(a, Math.max(b, c));
    }
}
