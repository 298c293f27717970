package rasterlab.engine.spline;

import rasterlab.contract.SplineFunction.Promise;

/**
 * The values of a spline function at the places of a problem.
 *
 * @param promise what the method that made them keeps to
 * @param y empty where the problem has no spline
 */
public record SplineValues(Promise promise, double[] y) {}
