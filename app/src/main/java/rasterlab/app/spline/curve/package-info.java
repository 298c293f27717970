/**
 * The details of a curve that the lab shows beside its line: points and their construction, the
 * blending functions, the comb of curvature, and how two curves meet.
 *
 * <p>Pixels, t in [0, 1]. Start with {@link rasterlab.app.spline.curve.CurveAt} and {@link
 * rasterlab.app.spline.curve.Sampling}; the panels that show these stand in {@code
 * rasterlab.app.spline}.
 */
package rasterlab.app.spline.curve;
