package rasterlab.contract;

/**
 * Tells whether a point of the plane lies in a triangle.
 *
 * <p>The triangle is the set of points between its corners, its sides and corners included: a point
 * exactly on a side is inside. It does not matter which way round the corners are given. Corners on
 * one straight line make a triangle without area: the segment they span, or one point, all of it
 * inside.
 *
 * <p>Any finite coordinates are allowed, in any unit; y may grow up or down.
 */
@FunctionalInterface
public interface PointInTriangle {
    /**
     * Whether the point (x, y) lies in the triangle a, b, c or on its boundary.
     *
     * @throws IllegalArgumentException if a coordinate is NaN or infinite; a method for triangles
     *     with an area alone may refuse one without, and one in whole numbers a fraction; the
     *     message names the value and the range
     */
    boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y);
}
