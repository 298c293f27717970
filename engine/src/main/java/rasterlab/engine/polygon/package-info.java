/**
 * Points and polygons of the plane: what is inside, and how to cut it into triangles.
 *
 * <p>Mathematical axes: x grows to the right, y up. A polygon is its corners, the last joined to
 * the first. Below this package: {@code triangle} tells whether a point is in a triangle, {@code
 * inside} whether it is in any polygon, {@code triangulation} cuts polygons into triangles. Here is
 * what they share; start with {@link rasterlab.engine.polygon.Points}.
 */
package rasterlab.engine.polygon;
