package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;

/**
 * One span of any curve as the control points of a Bézier curve; of at least degree 3, so that
 * lower degrees need no code of their own.
 *
 * <p>Source: each kind's matrix times the inverse of the Bézier matrix.
 */
final class BezierPoints {
    final double[] x;
    final double[] y;
    private final Curve curve;

    /** The first span. */
    BezierPoints(Curve curve) {
        this.curve = curve;
        int points = Math.max(curve.degree(), 3) + 1;
        x = new double[points];
        y = new double[points];
        load(0);
    }

    /** Degree, at least 3. */
    int degree() {
        return x.length - 1;
    }

    void load(int span) {
        load(curve.x(), span, x);
        load(curve.y(), span, y);
    }

    private void load(double[] p, int i, double[] b) {
        switch (curve.kind()) {
            case BEZIER -> elevated(p, b);
            case HERMITE -> set(b, p[0], p[0] + p[2] / 3, p[1] - p[3] / 3, p[1]);
            case CATMULL_ROM ->
                    set(
                            b,
                            p[i + 1],
                            p[i + 1] + (p[i + 2] - p[i]) / 6,
                            p[i + 2] - (p[i + 3] - p[i + 1]) / 6,
                            p[i + 2]);
            case B_SPLINE ->
                    set(
                            b,
                            (p[i] + 4 * p[i + 1] + p[i + 2]) / 6,
                            (2 * p[i + 1] + p[i + 2]) / 3,
                            (p[i + 1] + 2 * p[i + 2]) / 3,
                            (p[i + 1] + 4 * p[i + 2] + p[i + 3]) / 6);
        }
    }

    private static void elevated(double[] p, double[] b) {
        switch (p.length) {
            case 1 -> set(b, p[0], p[0], p[0], p[0]);
            case 2 -> set(b, p[0], (2 * p[0] + p[1]) / 3, (p[0] + 2 * p[1]) / 3, p[1]);
            case 3 -> set(b, p[0], (p[0] + 2 * p[1]) / 3, (2 * p[1] + p[2]) / 3, p[2]);
            default -> System.arraycopy(p, 0, b, 0, p.length);
        }
    }

    private static void set(double[] b, double start, double second, double third, double end) {
        b[0] = start;
        b[1] = second;
        b[2] = third;
        b[3] = end;
    }

    private BezierPoints(Curve curve, double[] x, double[] y) {
        this.curve = curve;
        this.x = x;
        this.y = y;
    }

    BezierPoints copy() {
        return new BezierPoints(curve, x.clone(), y.clone());
    }

    /** The half up to u = ½; what remains here is the other half. */
    BezierPoints firstHalf() {
        return new BezierPoints(curve, firstHalf(x), firstHalf(y));
    }

    /** The left side of de Casteljau's triangle for u = ½; its right side stays in {@code p}. */
    private static double[] firstHalf(double[] p) {
        var first = new double[p.length];
        for (int row = p.length - 1; row >= 0; row--) {
            first[p.length - 1 - row] = p[0];
            for (int i = 0; i < row; i++) p[i] = 0.5 * (p[i] + p[i + 1]);
        }
        return first;
    }

    /** The largest second difference of neighbouring points: |P[i] − 2·P[i+1] + P[i+2]|. */
    double bend() {
        double largest = 0;
        for (int i = 0; i + 2 < x.length; i++) {
            double dx = x[i] - 2 * x[i + 1] + x[i + 2];
            double dy = y[i] - 2 * y[i + 1] + y[i + 2];
            double square = dx * dx + dy * dy;
            if (square > largest) largest = square;
        }
        return Math.sqrt(largest);
    }
}
