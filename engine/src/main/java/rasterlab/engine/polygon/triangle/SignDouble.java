package rasterlab.engine.polygon.triangle;

/**
 * Trager's sign method in double: inside where three cross products have equal sign bits.
 *
 * <p>{@code side(p, q) = (y − py)·(qx − px) − (x − px)·(qy − py)}, for the sides a–c, c–b and b–a,
 * compared by the exclusive or of their bits as in {@link SignInt}.
 *
 * <p>−0.0 has its sign bit set, so a point on a side may count as beyond it, whichever way round
 * the corners go; near a side the products' rounding decides. Three zeros agree, so of corners on
 * one line the whole line is inside.
 *
 * <p>Source: D. Trager's idea of 2005, in A. V. Kazantsev, Foundations of computer graphics for
 * programmers, Kazan, 2005, ch. 1.
 */
final class SignDouble implements SteppedTriangleTest {
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

    @Override
    public int[] corners(int side) {
        return SideWalk.backwards(side);
    }

    private static final class Walk extends SideWalk {
        private double first;

        Walk(double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
            super(ax, ay, bx, by, cx, cy, x, y);
        }

        @Override
        double ask(int side) {
            return switch (side) {
                case 0 -> first = side(ax, ay, cx, cy);
                case 1 -> side(cx, cy, bx, by);
                default -> side(bx, by, ax, ay);
            };
        }

        private double side(double px, double py, double qx, double qy) {
            spend(2, 5);
            return (y - py) * (qx - px) - (x - px) * (qy - py);
        }

        /** Whether the sign bits differ; −0 has one, 0 and, so read, NaN have none. */
        @Override
        boolean outside(int side, double value) {
            return (Double.doubleToLongBits(first) ^ Double.doubleToLongBits(value)) < 0;
        }
    }
}
