/**
 * The cheapest way to draw a curve within a tolerance, by how often its polyline is drawn.
 *
 * <p>Pixels, nanoseconds of processor time. Start with {@link
 * rasterlab.engine.spline.plan.CurvePlan}.
 */
package rasterlab.engine.spline.plan;
