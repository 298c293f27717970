package rasterlab.engine.spline.function;

/**
 * A spline on its way to its coefficients, one row of the equations or one piece per step.
 *
 * <p>A new walk stands before its first step. Drain it with {@code while (walk.advance()) …}.
 */
public interface SplineWalk {
    /** Takes the next step; false when there is none, and then again each time. */
    boolean advance();

    /** Row of the system or number of the piece that the step dealt with, from 0. */
    int index();

    /** The step, in one word. */
    String phase();

    /** The number that the step looked at or found; see {@link SteppedSpline#decisionFormula}. */
    double decision();

    /** How many steps so far had to do something out of the ordinary: swap rows, limit slopes. */
    long exceptions();
}
