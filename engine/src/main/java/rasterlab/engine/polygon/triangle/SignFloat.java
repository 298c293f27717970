package rasterlab.engine.polygon.triangle;

/**
 * Träger's sign method in float: {@link SignDouble} with half the bits.
 *
 * <p>Coordinates are rounded to 24 bits first: 2²⁴ + 1 and 2²⁴ become one. Those beyond the largest
 * float are refused. Products overflow from about 2⁶³ on and vanish below 2⁻⁷⁵.
 */
final class SignFloat implements SideTests {
    @Override
    public int asked(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        SideTests.requireFinite(ax, ay, bx, by, cx, cy, x, y);
        return asked(
                rounded(ax),
                rounded(ay),
                rounded(bx),
                rounded(by),
                rounded(cx),
                rounded(cy),
                rounded(x),
                rounded(y));
    }

    private static int asked(
            float ax, float ay, float bx, float by, float cx, float cy, float x, float y) {
        float first = (y - ay) * (cx - ax) - (x - ax) * (cy - ay);
        float second = (y - cy) * (bx - cx) - (x - cx) * (by - cy);
        if (differ(first, second)) return -2;
        float third = (y - by) * (ax - bx) - (x - bx) * (ay - by);
        return differ(first, third) ? -3 : 3;
    }

    /** Whether the sign bits differ; −0 has one, 0 and, on every machine so read, NaN have none. */
    private static boolean differ(float a, float b) {
        return (Float.floatToIntBits(a) ^ Float.floatToIntBits(b)) < 0;
    }

    private static float rounded(double coordinate) {
        float value = (float) coordinate;
        if (Float.isInfinite(value))
            throw new IllegalArgumentException(
                    "coordinates must be from -3.4028235E38 to 3.4028235E38, got " + coordinate);
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
