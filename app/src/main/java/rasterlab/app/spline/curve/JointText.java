package rasterlab.app.spline.curve;

import rasterlab.engine.spline.curve.CurveJoint;

/** The short signs of continuity, the same in every language. */
public final class JointText {
    private JointText() {}

    public static String of(CurveJoint.Continuity kind) {
        return switch (kind) {
            case GAP -> "×";
            case C0 -> "C⁰";
            case G1 -> "G¹";
            case C1 -> "C¹";
            case C2 -> "C²";
        };
    }
}
