package rasterlab.engine.spline.curve;

/**
 * How far a cubic piece is from its chord, by its ends and its second derivatives there.
 *
 * <p>With s from 0 to 1 along a piece of width h, the piece leaves the point s of its chord by
 * {@code −h²·s·(1 − s)/6 · (a + d·s)}, where {@code a = 2·B″(0) + B″(1)} and {@code d = B″(1) −
 * B″(0)}. Only the part across the chord is distance, so long as no point lies beyond the chord's
 * ends; the inner Bézier points say so when both stand beside the chord. The part across is largest
 * where its derivative, {@code a + 2·(d − a)·s − 3·d·s²}, is 0. The distance is exact but for
 * rounding, and it holds both ways: no point of the chord is farther from the piece.
 *
 * <p>Derived here; B″ of a cubic is linear, and so is its difference from the chord's two ends.
 */
final class ChordDistance {
    private ChordDistance() {}

    /**
     * The distance in pixels; infinite where the piece may reach beyond its chord's ends.
     *
     * @param chordX from the piece's start to its end
     * @param bendX x of B″ at the start
     * @param endBendX x of B″ at the end
     * @param square h²
     */
    static double of(
            double chordX,
            double chordY,
            double bendX,
            double bendY,
            double endBendX,
            double endBendY,
            double square) {
        double length = Math.sqrt(chordX * chordX + chordY * chordY);
        if (length == 0) return Double.POSITIVE_INFINITY;
        double alongX = chordX / length;
        double alongY = chordY / length;
        double along = alongX * bendX + alongY * bendY;
        double endAlong = alongX * endBendX + alongY * endBendY;
        double first = length / 3 - square * (2 * along + endAlong) / 18;
        double second = 2 * length / 3 - square * (along + 2 * endAlong) / 18;
        if (first < 0 || first > length || second < 0 || second > length)
            return Double.POSITIVE_INFINITY;
        double across = alongX * bendY - alongY * bendX;
        double endAcross = alongX * endBendY - alongY * endBendX;
        return square / 6 * largest(2 * across + endAcross, endAcross - across);
    }

    /**
     * The larger distance of the two inner Bézier points from the chord, ends included, which no
     * point of the piece exceeds: wherever the piece may run.
     *
     * @param chordX as for {@link #of}, and so are the others
     */
    static double ofHull(
            double chordX,
            double chordY,
            double bendX,
            double bendY,
            double endBendX,
            double endBendY,
            double square) {
        double third = square / 18;
        return Math.sqrt(
                Math.max(
                        fromSegment(
                                chordX,
                                chordY,
                                chordX / 3 - third * (2 * bendX + endBendX),
                                chordY / 3 - third * (2 * bendY + endBendY)),
                        fromSegment(
                                chordX,
                                chordY,
                                2 * chordX / 3 - third * (bendX + 2 * endBendX),
                                2 * chordY / 3 - third * (bendY + 2 * endBendY))));
    }

    /** The square of the distance of (x, y) from the segment from (0, 0) to the chord's end. */
    private static double fromSegment(double chordX, double chordY, double x, double y) {
        double along = chordX * x + chordY * y;
        double length = chordX * chordX + chordY * chordY;
        if (!(along > 0)) return x * x + y * y;
        if (along >= length) return (x - chordX) * (x - chordX) + (y - chordY) * (y - chordY);
        double across = chordX * y - chordY * x;
        return across * (across / length);
    }

    /** The largest {@code |s·(1 − s)·(a + d·s)|} for s from 0 to 1. */
    private static double largest(double a, double d) {
        double root = Math.sqrt(a * a + a * d + d * d);
        double q = a - d + Math.copySign(root, a - d);
        return Math.max(at(a / q, a, d), at(q / (-3 * d), a, d));
    }

    /** 0 where {@code s} is outside the piece or no number. */
    private static double at(double s, double a, double d) {
        return s > 0 && s < 1 ? Math.abs(s * (1 - s) * (a + d * s)) : 0;
    }
}
