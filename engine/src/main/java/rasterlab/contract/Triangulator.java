package rasterlab.contract;

/**
 * Cuts a polygon into triangles between its own corners.
 *
 * <p>Corner i is (x[i], y[i]); the last is joined to the first. The polygon is simple: edges meet
 * only at the corner they share. It may go round either way. A corner equal to the one before it is
 * passed over. Corners on a straight side are allowed.
 *
 * <p>The triangles have area, cover the polygon, and do not overlap: n corners give n − 2 of them.
 * Each goes counter-clockwise, y growing up: (bx − ax)·(cy − ay) − (by − ay)·(cx − ax) &gt; 0.
 * Their order, and which corner comes first, do not matter.
 */
@FunctionalInterface
public interface Triangulator {
    /**
     * The triangles, three corner numbers each, one after another.
     *
     * @param x any finite coordinates, in any unit; not to be changed
     * @param y as many as {@code x}, growing up; not to be changed
     * @throws IllegalArgumentException if there are fewer than 3 different corners, a coordinate is
     *     NaN or infinite, the polygon crosses or touches itself or has no area; a method may
     *     refuse, too, more than 20,000 corners, and one for convex polygons those that are not;
     *     the message names place, value and what is allowed
     */
    int[] triangulate(double[] x, double[] y);
}
