package rasterlab.engine.spline.exact;

import rasterlab.contract.Curve;

/**
 * One input of the topic.
 *
 * @param at where points are wanted; empty where a polyline is
 * @param flatness of the polyline, in pixels; 0 where points are wanted
 */
public record CurveTask(Curve curve, double[] at, double flatness) {
    private static final double ROUNDING = 0x1p-30;

    public CurveTask {
        at = at.clone();
        if (at.length > 0 == flatness > 0)
            throw new IllegalArgumentException(
                    "a task has either at or flatness, got " + at.length + " and " + flatness);
    }

    /** Pixels that a result may be off: the flatness, or 2⁻³⁰ of the largest |coordinate|. */
    public double allowed() {
        return flatness > 0 ? flatness : curve.size() * ROUNDING;
    }

    public static CurveTask at(Curve curve, double... at) {
        return new CurveTask(curve, at, 0);
    }

    public static CurveTask flat(Curve curve, double flatness) {
        return new CurveTask(curve, new double[0], flatness);
    }

    @Override
    public String toString() {
        String wanted = flatness > 0 ? "flatness " + flatness : at.length + " points";
        return curve.kind().code() + " of " + curve.x().length + ", " + wanted;
    }
}
