/**
 * Is a point in a polygon? Rays that are counted, turns that are counted, and the exact answer.
 *
 * <p>Any unit, x to the right, y up or down. Each method walks round the polygon edge by edge and
 * can be watched: start with {@link rasterlab.engine.polygon.inside.EdgeWalk} and {@link
 * rasterlab.engine.polygon.inside.RobustRay}; {@link
 * rasterlab.engine.polygon.inside.PointInPolygonTopic} lists everything.
 */
package rasterlab.engine.polygon.inside;
