/**
 * The lab of the topics {@code curve} and {@code spline-function}: curves by their control points,
 * and functions through knots.
 *
 * <p>Curves lie on a raster: pixels, x right and y down; functions in a plane with y up. The two
 * models {@link rasterlab.app.spline.CurveLabModel} and {@link
 * rasterlab.app.spline.FunctionLabModel} know no Swing; {@link rasterlab.app.spline.SplinePanel}
 * shows one of them at a time.
 */
package rasterlab.app.spline;
