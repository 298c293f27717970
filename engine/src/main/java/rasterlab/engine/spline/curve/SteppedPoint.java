package rasterlab.engine.spline.curve;

import java.util.List;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveTracer;

/** A method whose way to a single point can be looked at. */
public interface SteppedPoint extends CurveTracer {
    /**
     * The steps to the point that {@code at} sends for {@code t}.
     *
     * @param t in [0, 1]
     * @throws IllegalArgumentException as {@code at} does
     */
    List<PointStep> stepsAt(Curve curve, double t);
}
