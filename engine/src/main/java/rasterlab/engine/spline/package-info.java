/**
 * Cubic splines: functions through points, and curves by their control points.
 *
 * <p>Functions: knots x[i], values y[i], widths h[i], secants δ[i], slopes k[i]; start with {@link
 * rasterlab.engine.spline.CubicSpline} and {@link rasterlab.engine.spline.SplineFunctionTopic}.
 */
package rasterlab.engine.spline;
