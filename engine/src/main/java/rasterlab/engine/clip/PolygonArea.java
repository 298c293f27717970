package rasterlab.engine.clip;

/** Areas of polygons given as x and y of each corner in turn. */
final class PolygonArea {
    /** An area below this share of its extents' product is rounding. */
    private static final double ROUNDING = 0x1p-46;

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

    /** Whether a ring encloses more than rounding can. */
    static boolean isAny(double[] xy) {
        if (xy.length < 6) return false;
        double width = 0;
        double height = 0;
        for (int i = 2; i < xy.length; i += 2) {
            width = Math.max(width, Math.abs(xy[i] - xy[0]));
            height = Math.max(height, Math.abs(xy[i + 1] - xy[1]));
        }
        return of(xy) > ROUNDING * width * height;
    }
}
