package rasterlab.engine.clip.polygon;

/** Areas of polygons given as x and y of each corner in turn. */
final class PolygonArea {
    /** A ring larger than this share of the window's square was not made by rounding. */
    private static final double CLEAR = 0x1p-30;

    private PolygonArea() {}

    /** Half the sum of the cross products about the first corner; above 0 counter-clockwise. */
    static double of(double[] xy) {
        double twice = 0;
        for (int i = 2; i + 3 < xy.length; i += 2)
            twice +=
                    (xy[i] - xy[0]) * (xy[i + 3] - xy[1])
                            - (xy[i + 2] - xy[0]) * (xy[i + 1] - xy[1]);
        return twice / 2;
    }

    /**
     * Whether a ring in a window surely encloses more than the rounding of its corners can: they
     * move by less than 2⁻³⁷ of the window's extent. All is first divided by the power of 2 that
     * makes the window's largest coordinate about 1, so that no product overflows; one that
     * vanishes makes this false.
     */
    static boolean isClear(double[] xy, double[] window) {
        int down = -exponent(window, 0, 1);
        double[] near = scaled(window, down, down);
        double size = Math.max(extent(near, 0), extent(near, 1));
        return of(scaled(xy, down, down)) > CLEAR * size * size;
    }

    /** The exponent of the largest of every {@code step}-th number from {@code start}. */
    static int exponent(double[] numbers, int start, int step) {
        double most = 0;
        for (int i = start; i < numbers.length; i += step)
            most = Math.max(most, Math.abs(numbers[i]));
        return Math.getExponent(most);
    }

    /** The corners with x times 2^{@code byX} and y times 2^{@code byY}. */
    static double[] scaled(double[] xy, int byX, int byY) {
        var scaled = new double[xy.length];
        for (int i = 0; i < xy.length; i++) scaled[i] = Math.scalb(xy[i], i % 2 == 0 ? byX : byY);
        return scaled;
    }

    private static double extent(double[] xy, int start) {
        double least = xy[start];
        double most = xy[start];
        for (int i = start; i < xy.length; i += 2) {
            least = Math.min(least, xy[i]);
            most = Math.max(most, xy[i]);
        }
        return most - least;
    }
}
