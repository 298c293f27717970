package rasterlab.engine.polygon.triangle;

/**
 * Trager's sign method in int: inside where three cross products have equal sign bits.
 *
 * <p>{@code side(p, q) = (y − py)·(qx − px) − (x − px)·(qy − py)}, for the sides a–c, c–b and b–a.
 * Two numbers have different sign bits where their exclusive or is negative; the second pair is
 * asked only if the first agrees, so 4 multiplications and 10 subtractions or 6 and 15.
 *
 * <p>Coordinates have to be whole. Past ±2¹⁵ or so the products overflow. 0 has the sign bit of a
 * positive number, so the boundary is inside where the sides' values are positive and outside where
 * the corners go the other way round.
 *
 * <p>Source: D. Trager's idea of 2005, in A. V. Kazantsev, Foundations of computer graphics for
 * programmers, Kazan, 2005, ch. 1.
 */
final class SignInt implements SteppedTriangleTest {
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

    private static int whole(double coordinate) {
        int value = (int) coordinate;
        if (value != coordinate)
            throw new IllegalArgumentException(
                    "coordinates must be whole numbers from -2147483648 to 2147483647, got "
                            + coordinate);
        return value;
    }

    @Override
    public int[] corners(int side) {
        return SideWalk.backwards(side);
    }

    private static final class Walk extends SideWalk {
        private final int axWhole;
        private final int ayWhole;
        private final int bxWhole;
        private final int byWhole;
        private final int cxWhole;
        private final int cyWhole;
        private final int xWhole;
        private final int yWhole;
        private int first;

        Walk(double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
            super(ax, ay, bx, by, cx, cy, x, y);
            axWhole = whole(ax);
            ayWhole = whole(ay);
            bxWhole = whole(bx);
            byWhole = whole(by);
            cxWhole = whole(cx);
            cyWhole = whole(cy);
            xWhole = whole(x);
            yWhole = whole(y);
        }

        @Override
        double ask(int side) {
            return switch (side) {
                case 0 -> first = side(axWhole, ayWhole, cxWhole, cyWhole);
                case 1 -> side(cxWhole, cyWhole, bxWhole, byWhole);
                default -> side(bxWhole, byWhole, axWhole, ayWhole);
            };
        }

        private int side(int px, int py, int qx, int qy) {
            spend(2, 5);
            return (yWhole - py) * (qx - px) - (xWhole - px) * (qy - py);
        }

        @Override
        boolean outside(int side, double value) {
            return (first ^ (int) value) < 0;
        }
    }
}
