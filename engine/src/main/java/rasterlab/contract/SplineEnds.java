package rasterlab.contract;

/**
 * The two equations that a cubic spline needs beside those of its knots.
 *
 * @param kind what holds at the ends
 * @param left slope at the first knot, for {@link Kind#SLOPES} only, otherwise 0
 * @param right slope at the last knot, for {@link Kind#SLOPES} only, otherwise 0
 */
public record SplineEnds(Kind kind, double left, double right) {
    /** The condition at the ends. */
    public enum Kind {
        /** The slopes are given; two knots make one cubic. */
        SLOPES,
        /** The second derivative is 0 at both ends; two knots make a straight line. */
        NATURAL,
        /**
         * The third derivative does not jump at the second and the last but one knot: the first two
         * pieces are one cubic, and so are the last two. Three knots make a parabola, two a line.
         */
        NOT_A_KNOT,
        /**
         * The last knot is the first one again, one period on: same value (required), slope and
         * second derivative. Two knots make a constant.
         */
        PERIODIC
    }

    public SplineEnds {
        if (!Double.isFinite(left) || !Double.isFinite(right))
            throw new IllegalArgumentException(
                    "end slopes must be finite, got " + left + " and " + right);
        if (kind != Kind.SLOPES && (left != 0 || right != 0))
            throw new IllegalArgumentException(
                    "only ends of kind SLOPES have slopes, got " + left + " and " + right);
    }

    public static SplineEnds slopes(double left, double right) {
        return new SplineEnds(Kind.SLOPES, left, right);
    }

    public static SplineEnds natural() {
        return new SplineEnds(Kind.NATURAL, 0, 0);
    }

    public static SplineEnds notAKnot() {
        return new SplineEnds(Kind.NOT_A_KNOT, 0, 0);
    }

    public static SplineEnds periodic() {
        return new SplineEnds(Kind.PERIODIC, 0, 0);
    }
}
