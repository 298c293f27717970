package rasterlab.engine.spline.curve;

import rasterlab.contract.CurvePoints;

/**
 * A curve on its way from its start to its end, one corner of the polyline per step.
 *
 * <p>A new walk stands before its first point. Drain it with {@code while (walk.advance())
 * out.point(walk.x(), walk.y());}.
 */
public interface CurveWalk {
    /** Moves to the next point; false when there is none, and then again each time. */
    boolean advance();

    /** The point's x, in pixels. */
    double x();

    /** The point's y, in pixels. */
    double y();

    /** Where on the curve the point lies, from 0 to 1. */
    double t();

    /** The number that made the method go on to this point; see {@link SteppedCurve}. */
    double decision();

    /** How many pieces were found too bent and halved so far; 0 for methods that never do. */
    default long splits() {
        return 0;
    }

    /** Takes all remaining steps. */
    default void drain(CurvePoints out) {
        while (advance()) out.point(x(), y());
    }
}
