/**
 * Curves by their control points drawn as polylines, and topic {@code spline}.
 *
 * <p>Pixels, t in [0, 1] along the whole curve, u in [0, 1] along one span. Start with {@link
 * rasterlab.engine.spline.curve.DeCasteljauCurve} and {@link
 * rasterlab.engine.spline.curve.AdaptiveCurve}, then {@link
 * rasterlab.engine.spline.curve.CurveTopic}; {@link rasterlab.engine.spline.curve.CurveMatrix}
 * holds the kinds of curve.
 */
package rasterlab.engine.spline.curve;
