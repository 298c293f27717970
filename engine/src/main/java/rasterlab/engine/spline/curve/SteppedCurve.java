package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;
import rasterlab.contract.CurveTracer;

/** A method whose steps can be looked at: flattening and stepping drain the same walk. */
public interface SteppedCurve extends CurveTracer {
    /**
     * A walk over the corners that {@code flatten} sends, in the same order.
     *
     * @throws IllegalArgumentException as {@code flatten} does
     */
    CurveWalk walk(Curve curve, double flatness);

    /** The formula of {@link CurveWalk#decision}. */
    String decisionFormula();
}
