package rasterlab.contract;

/**
 * Clips a polygon by a convex window.
 *
 * <p>Both are given as x and y of each corner in turn, in either direction, the last joined to the
 * first. The window is convex with an area above 0. The subject is simple: its edges meet nowhere
 * but at the corner two neighbours share; corners may lie on the window's sides, and edges along
 * them. A corner in the same place as the one before it, in either of the two, counts as one with
 * it; three different ones must be left.
 *
 * <p>What is left is the part of the subject's area in the window, as one polygon for each
 * connected piece, counter-clockwise where y grows up, in any order and from any corner on. The
 * window is closed. A piece without area (a touched corner or side), or of which rounding leaves
 * fewer than three corners, is not sent. A corner in the window stays as it is. The area that only
 * one of the pieces sent and the exact ones cover is at most 10⁻¹² of the window's, or what an
 * exercise allows.
 *
 * <p>An exercise may ask for one polygon in place of the pieces, as I. E. Sutherland and G. W.
 * Hodgman's method leaves it: then pieces stay joined by bridges without area along the window's
 * sides, and it says so.
 */
@FunctionalInterface
public interface PolygonClipper {
    /**
     * Sends each piece of {@code subject} in {@code window}, once.
     *
     * @param window at least three corners; not changed
     * @param subject at least three corners; not changed
     * @throws IllegalArgumentException if a number is not finite, the window is not convex, the
     *     subject is not simple, or one has fewer than three different corners or more than 2²⁴;
     *     the message names the corner, its value and what is allowed
     */
    void clip(double[] window, double[] subject, PolygonSink out);
}
