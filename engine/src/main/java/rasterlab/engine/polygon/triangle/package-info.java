/**
 * Is a point in a triangle? Six classic methods, each with its weak spot, and one that is always
 * right.
 *
 * <p>Any unit, x to the right, y up or down. The classics are kept as they are taught, so that
 * their failures can be seen; {@link rasterlab.engine.polygon.triangle.RobustTriangle} is the one
 * to use. Start with {@link rasterlab.engine.polygon.triangle.SignDouble}; {@link
 * rasterlab.engine.polygon.triangle.PointInTriangleTopic} lists everything.
 */
package rasterlab.engine.polygon.triangle;
