package rasterlab.contract;

/**
 * Tells whether a point of the plane lies in a polygon.
 *
 * <p>Corner i is (polygonX[i], polygonY[i]); the last is joined to the first. A point exactly on an
 * edge or a corner is inside. Any other point is inside when a ray from it, in whatever direction,
 * crosses the edges an odd number of times (the even-odd rule), so where a polygon covers itself
 * twice is outside. It does not matter which way round the corners go; repeated corners and edges
 * that lie on each other are allowed.
 *
 * <p>At least 3 corners; any finite coordinates, in any unit; y may grow up or down.
 */
@FunctionalInterface
public interface PointInPolygon {
    /**
     * Whether the point (x, y) lies in the polygon or on its boundary.
     *
     * @param polygonX not to be changed
     * @param polygonY as many as {@code polygonX}; not to be changed
     * @throws IllegalArgumentException if there are fewer than 3 corners, the arrays differ in
     *     length, or a coordinate is NaN or infinite; the message names place and value
     */
    boolean contains(double[] polygonX, double[] polygonY, double x, double y);
}
