package rasterlab.engine.polygon.triangle;

/**
 * Trager's sign method in float: {@link SignDouble} with half the bits.
 *
 * <p>Coordinates are rounded to 24 bits first: 2²⁴ + 1 and 2²⁴ become one. Those beyond the largest
 * float are refused. Products overflow from about 2⁶³ on and vanish below 2⁻⁷⁵.
 *
 * <p>Source: D. Trager's idea of 2005, in A. V. Kazantsev, Foundations of computer graphics for
 * programmers, Kazan, 2005, ch. 1.
 */
final class SignFloat implements SteppedTriangleTest {
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
        return "(y − py)·(qx − px) − (x − px)·(qy − py) for the sides a–c, c–b, b–a; inside where all three"
                + " sign bits are equal";
    }

    private static float rounded(double coordinate) {
        float value = (float) coordinate;
        if (Float.isInfinite(value))
            throw new IllegalArgumentException(
                    "coordinates must be from -3.4028235E38 to 3.4028235E38, got " + coordinate);
        return value;
    }

    @Override
    public int[] corners(int side) {
        return SideWalk.backwards(side);
    }

    private static final class Walk extends SideWalk {
        private final float axRounded;
        private final float ayRounded;
        private final float bxRounded;
        private final float byRounded;
        private final float cxRounded;
        private final float cyRounded;
        private final float xRounded;
        private final float yRounded;
        private double first;

        Walk(double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
            super(ax, ay, bx, by, cx, cy, x, y);
            axRounded = rounded(ax);
            ayRounded = rounded(ay);
            bxRounded = rounded(bx);
            byRounded = rounded(by);
            cxRounded = rounded(cx);
            cyRounded = rounded(cy);
            xRounded = rounded(x);
            yRounded = rounded(y);
        }

        @Override
        double ask(int side) {
            return switch (side) {
                case 0 -> first = side(axRounded, ayRounded, cxRounded, cyRounded);
                case 1 -> side(cxRounded, cyRounded, bxRounded, byRounded);
                default -> side(bxRounded, byRounded, axRounded, ayRounded);
            };
        }

        private float side(float px, float py, float qx, float qy) {
            spend(2, 5);
            return (yRounded - py) * (qx - px) - (xRounded - px) * (qy - py);
        }

        /** Whether the sign bits differ; −0 has one, 0 and, so read, NaN have none. */
        @Override
        boolean outside(int side, double value) {
            return (Double.doubleToLongBits(first) ^ Double.doubleToLongBits(value)) < 0;
        }
    }
}
