package rasterlab.engine.polygon.triangle;

/**
 * Träger's sign method in int: inside where three cross products have equal sign bits.
 *
 * <p>{@code side(p, q) = (y − py)·(qx − px) − (x − px)·(qy − py)}, for the sides a–c, c–b and b–a.
 * Two numbers have different sign bits where their exclusive or is negative; the second pair is
 * asked only if the first agrees, so 4 multiplications and 10 subtractions or 6 and 15.
 *
 * <p>Coordinates have to be whole. Past ±2¹⁵ or so the products overflow. 0 has the sign bit of a
 * positive number, so the boundary is inside where the sides' values are positive and outside where
 * the corners go the other way round.
 */
final class SignInt implements SideTests {
    @Override
    public int asked(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        return asked(
                whole(ax), whole(ay), whole(bx), whole(by), whole(cx), whole(cy), whole(x),
                whole(y));
    }

    private static int asked(int ax, int ay, int bx, int by, int cx, int cy, int x, int y) {
        int first = (y - ay) * (cx - ax) - (x - ax) * (cy - ay);
        int second = (y - cy) * (bx - cx) - (x - cx) * (by - cy);
        if ((first ^ second) < 0) return -2;
        int third = (y - by) * (ax - bx) - (x - bx) * (ay - by);
        return (first ^ third) < 0 ? -3 : 3;
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
    public int multiplicationsPerSide() {
        return 2;
    }

    @Override
    public int additionsPerSide() {
        return 5;
    }
}
