package rasterlab.app.spline.curve;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.curve.CurveJoint;
import rasterlab.engine.spline.curve.CurvePlace;

/**
 * Where two spans meet, and how smoothly.
 *
 * @param x pixels
 * @param y pixels
 */
public record Joint(double x, double y, CurveJoint.Continuity kind) {
    private static final int MOST = 64;

    /** The joints of all curves' spans, from start to end; none where there are more than 64. */
    public static List<Joint> all(List<Curve> curves) {
        int spans = curves.stream().mapToInt(Curve::spans).sum();
        if (spans > MOST) return List.of();
        var joints = new ArrayList<Joint>();
        CurvePlace before = null;
        for (Curve curve : curves)
            for (int span = 0; span < curve.spans(); span++) {
                if (before != null) {
                    var joint = new CurveJoint(before, CurvePlace.of(curve, span, 0));
                    joints.add(new Joint(before.x(), before.y(), joint.kind()));
                }
                before = CurvePlace.of(curve, span, 1);
            }
        return List.copyOf(joints);
    }
}
