package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;

/**
 * The matrices M that make a span from its control points: point(u) = [uⁿ … u² u 1]·M·G.
 *
 * <p>Rows by falling powers of u, columns by control points: in the textbook's layout. Source: J.
 * D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics: Principles and Practice,
 * 1990, chapter 11.
 */
public final class CurveMatrix {
    private CurveMatrix() {}

    /** M_h, for G = [P1, P4, R1, R4]. */
    public static double[][] hermite() {
        return new double[][] {
            {2, -2, 1, 1},
            {-3, 3, -2, -1},
            {0, 0, 1, 0},
            {1, 0, 0, 0}
        };
    }

    /** M_hb, which makes Hermite's [P1, P4, R1, R4] of Bézier's [P1, P2, P3, P4]. */
    public static double[][] hermiteOfBezier() {
        return new double[][] {
            {1, 0, 0, 0},
            {0, 0, 0, 1},
            {-3, 3, 0, 0},
            {0, 0, -3, 3}
        };
    }

    /** M_b of any degree n: (−1)^(j−i)·C(n, j)·C(j, i) at power j and point i ≤ j. */
    public static double[][] bezier(int degree) {
        var matrix = new double[degree + 1][degree + 1];
        double ofPower = 1;
        for (int j = 0; j <= degree; j++) {
            double ofPoint = (j & 1) == 0 ? ofPower : -ofPower;
            for (int i = 0; i <= j; i++) {
                matrix[degree - j][i] = ofPoint;
                ofPoint = -ofPoint * (j - i) / (i + 1);
            }
            ofPower = ofPower * (degree - j) / (j + 1);
        }
        return matrix;
    }

    /** Twice the Catmull–Rom matrix. */
    static double[][] twiceCatmullRom() {
        return new double[][] {
            {-1, 3, -3, 1},
            {2, -5, 4, -1},
            {-1, 0, 1, 0},
            {0, 2, 0, 0}
        };
    }

    /** Six times the matrix of the uniform B-spline. */
    static double[][] sixBSpline() {
        return new double[][] {
            {-1, 3, -3, 1},
            {3, -6, 3, 0},
            {-3, 0, 3, 0},
            {1, 4, 1, 0}
        };
    }

    /** The matrix of the curve's kind, times {@link #divisor}. */
    static double[][] of(Curve curve) {
        return switch (curve.kind()) {
            case BEZIER -> bezier(curve.degree());
            case HERMITE -> hermite();
            case CATMULL_ROM -> twiceCatmullRom();
            case B_SPLINE -> sixBSpline();
        };
    }

    static double divisor(Curve curve) {
        return switch (curve.kind()) {
            case BEZIER, HERMITE -> 1;
            case CATMULL_ROM -> 2;
            case B_SPLINE -> 6;
        };
    }
}
