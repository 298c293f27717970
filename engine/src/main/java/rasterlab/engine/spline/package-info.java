/**
 * Cubic splines: functions through points, and curves by their control points.
 *
 * <p>Functions: knots x[i], values y[i], widths h[i], secants δ[i], slopes k[i]; start with {@link
 * rasterlab.engine.spline.CubicSpline} and {@link rasterlab.engine.spline.SplineFunctionTopic}.
 * Curves: pixels, t in [0, 1] along the whole curve, u in [0, 1] along one span; start with {@link
 * rasterlab.engine.spline.AdaptiveCurve} and {@link rasterlab.engine.spline.CurveTopic}.
 */
package rasterlab.engine.spline;
