/**
 * The references for curves of topic {@code spline}: exact points, a dense polyline, and how far
 * two polylines are apart.
 *
 * <p>Pixels. Knows no method that it judges. Start with {@link
 * rasterlab.engine.spline.exact.ExactCurve}, then {@link
 * rasterlab.engine.spline.exact.CurveComparison}.
 */
package rasterlab.engine.spline.exact;
