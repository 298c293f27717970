package rasterlab.engine.spline.curve;

/**
 * A cubic span by the coefficients of u³, u², u and 1, and how far its pieces are from their
 * chords.
 */
final class CubicPiece {
    private final double[] x = new double[4];
    private final double[] y = new double[4];

    void load(BezierPoints points) {
        load(points.x, x);
        load(points.y, y);
    }

    private static void load(double[] p, double[] c) {
        c[0] = p[0];
        c[1] = 3 * (p[1] - p[0]);
        c[2] = 3 * (p[0] - 2 * p[1] + p[2]);
        c[3] = p[3] - p[0] - 3 * (p[2] - p[1]);
    }

    double x(double u) {
        return ((x[3] * u + x[2]) * u + x[1]) * u + x[0];
    }

    double y(double u) {
        return ((y[3] * u + y[2]) * u + y[1]) * u + y[0];
    }

    /** x of B′. */
    double turnX(double u) {
        return (3 * x[3] * u + 2 * x[2]) * u + x[1];
    }

    double turnY(double u) {
        return (3 * y[3] * u + 2 * y[2]) * u + y[1];
    }

    /** |P₃ − 3P₂ + 3P₁ − P₀|, which is 0 for a parabola. */
    double third() {
        return Math.hypot(x[3], y[3]);
    }

    /**
     * Bounds how far the piece from u = {@code from} to {@code to} is from its chord, in pixels:
     * exact where no point lies beyond the chord's ends; elsewhere the least of two bounds.
     */
    double fromChord(double from, double to) {
        double width = to - from;
        double square = width * width;
        double bendX = 6 * x[3] * from + 2 * x[2];
        double bendY = 6 * y[3] * from + 2 * y[2];
        double endBendX = 6 * x[3] * to + 2 * x[2];
        double endBendY = 6 * y[3] * to + 2 * y[2];
        double chordX = x(to) - x(from);
        double chordY = y(to) - y(from);
        double across = ChordDistance.of(chordX, chordY, bendX, bendY, endBendX, endBendY, square);
        if (across < Double.POSITIVE_INFINITY) return across;
        double whole =
                square
                        / 8
                        * Math.sqrt(
                                Math.max(
                                        bendX * bendX + bendY * bendY,
                                        endBendX * endBendX + endBendY * endBendY));
        return Math.min(
                whole,
                ChordDistance.ofHull(chordX, chordY, bendX, bendY, endBendX, endBendY, square));
    }
}
