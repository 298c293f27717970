package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;

/** Which span a t lies in, and where there. */
final class CurveSpans {
    private CurveSpans() {}

    static int span(Curve curve, double t) {
        return Math.min((int) (t * curve.spans()), curve.spans() - 1);
    }

    /** The parameter within the span, from 0 to 1. */
    static double local(Curve curve, double t) {
        return t * curve.spans() - span(curve, t);
    }

    /**
     * Passes if every t is in [0, 1].
     *
     * @throws IllegalArgumentException naming the first that is not
     */
    static void requireInside(double... t) {
        for (int i = 0; i < t.length; i++)
            if (!(t[i] >= 0 && t[i] <= 1))
                throw new IllegalArgumentException(
                        "at[" + i + "] must be from 0 to 1, got " + t[i]);
    }
}
