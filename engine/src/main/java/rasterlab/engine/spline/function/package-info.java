/**
 * Cubic splines as functions through points, and topic {@code spline-function}.
 *
 * <p>Knots x[i], values y[i], widths h[i], secants δ[i], slopes k[i]. Start with {@link
 * rasterlab.engine.spline.function.CubicSpline}, then {@link
 * rasterlab.engine.spline.function.SplineFunctionTopic}; the exact answer is {@link
 * rasterlab.engine.spline.function.ExactSpline}.
 */
package rasterlab.engine.spline.function;
