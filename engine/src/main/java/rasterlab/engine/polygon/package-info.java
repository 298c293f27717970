/**
 * Points and polygons of the plane: what is inside, how to fill it and how to cut it into
 * triangles.
 *
 * <p>A polygon is its corners, the last joined to the first. Below this package: {@code triangle}
 * tells whether a point is in a triangle, {@code inside} whether it is in any polygon, {@code
 * triangulation} cuts polygons into triangles, all three in mathematical axes, x to the right and y
 * up; {@code scan} fills polygons in pixel coordinates, y down. Here is what they share; start with
 * {@link rasterlab.engine.polygon.Points}, and {@link rasterlab.engine.polygon.MeetingEdges} tells
 * whether a polygon crosses or touches itself.
 */
package rasterlab.engine.polygon;
