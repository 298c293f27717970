package rasterlab.engine.spline.function;

import rasterlab.contract.SplineFunction.Promise;

/**
 * The values of a spline function at the places of a problem.
 *
 * @param promise what the method that made them keeps to
 * @param coefficients how many there are, four for each piece where all is well
 * @param y NaN where the coefficients are none or too few; empty where the problem has no spline
 */
public record SplineValues(Promise promise, int coefficients, double[] y) {}
