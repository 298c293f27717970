package rasterlab.engine.spline.function;

import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;

/**
 * A method whose steps can be looked at: finding the second derivatives or slopes that make the
 * coefficients, and stepping, drain the same walk.
 */
public interface SteppedSpline extends SplineFunction {
    /**
     * A walk that {@code coefficients} drains.
     *
     * @throws IllegalArgumentException as {@code coefficients} does
     */
    SplineWalk walk(double[] x, double[] y, SplineEnds ends);

    /** The formula of {@link SplineWalk#decision}. */
    String decisionFormula();
}
