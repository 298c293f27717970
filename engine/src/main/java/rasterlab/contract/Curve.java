package rasterlab.contract;

/**
 * A plane curve by its control points, in pixels.
 *
 * <p>The arrays it hands out are its own and must not be changed. A curve has one or more spans,
 * each of them a polynomial of u in [0, 1]; t in [0, 1] runs over all spans evenly: span ⌊t·spans⌋,
 * and u is what is left.
 *
 * @param x 1 to 1,000,000 coordinates within ±10¹⁰⁰
 * @param y as many
 */
public record Curve(Kind kind, double[] x, double[] y) {
    /** How control points make a curve. */
    public enum Kind {
        /** One span of degree n by n + 1 points, 1 to {@value #MOST_BEZIER_POINTS} of them. */
        BEZIER("bezier"),
        /** One cubic: start, end, then the derivatives by u at the start and at the end. */
        HERMITE("hermite"),
        /** Cubics from the second point to the last but one, through all between; uniform. */
        CATMULL_ROM("catmull-rom"),
        /** Uniform cubics drawn to the points but through none: span i by points i to i + 3. */
        B_SPLINE("b-spline");

        private final String code;

        Kind(String code) {
            this.code = code;
        }

        /** Lower-case name, as read and printed. */
        public String code() {
            return code;
        }
    }

    /** The most control points of a Bézier curve, degree 100. */
    public static final int MOST_BEZIER_POINTS = 101;

    private static final int MOST_POINTS = 1_000_000;
    private static final double LARGEST = 1e100;

    public Curve {
        requireCount(kind, x.length);
        if (y.length != x.length)
            throw new IllegalArgumentException(
                    "points: " + x.length + " have x, " + y.length + " have y");
        x = x.clone();
        y = y.clone();
        for (int i = 0; i < x.length; i++) {
            requireCoordinate("x", i, x[i]);
            requireCoordinate("y", i, y[i]);
        }
    }

    private static void requireCount(Kind kind, int points) {
        int least = kind == Kind.BEZIER ? 1 : 4;
        int most = MOST_POINTS;
        if (kind == Kind.BEZIER) most = MOST_BEZIER_POINTS;
        if (kind == Kind.HERMITE) most = 4;
        String needed = least == most ? "" + least : least + " to " + most;
        if (points < least || points > most)
            throw new IllegalArgumentException(
                    "points must be " + needed + " for " + kind.code() + ", got " + points);
    }

    private static void requireCoordinate(String axis, int i, double value) {
        if (!(Math.abs(value) <= LARGEST))
            throw new IllegalArgumentException(
                    "points[%d].%s must be from %s to %s, got %s"
                            .formatted(i, axis, -LARGEST, LARGEST, value));
    }

    /** Number of polynomials. */
    public int spans() {
        return kind == Kind.BEZIER || kind == Kind.HERMITE ? 1 : x.length - 3;
    }

    /** Degree of each polynomial. */
    public int degree() {
        return kind == Kind.BEZIER ? x.length - 1 : 3;
    }

    /** The largest |coordinate|. */
    public double size() {
        double largest = 0;
        for (double each : x) if (Math.abs(each) > largest) largest = Math.abs(each);
        for (double each : y) if (Math.abs(each) > largest) largest = Math.abs(each);
        return largest;
    }
}
