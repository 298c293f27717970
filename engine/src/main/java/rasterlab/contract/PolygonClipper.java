package rasterlab.contract;

/**
 * Clips a polygon by a convex window.
 *
 * <p>Both are given as x and y of each corner in turn, in either direction, the last joined to the
 * first. The window is convex with an area above 0. The subject is simple: its edges meet nowhere
 * but at the corner two neighbours share; corners may lie on the window's sides, and edges along
 * them.
 *
 * <p>What is left is the part of the subject's area in the window, as one polygon for each
 * connected piece, counter-clockwise where y grows up. A piece without area (a touched corner or
 * side), or of which rounding leaves fewer than three corners, is not sent. A corner in the window
 * stays as it is.
 */
@FunctionalInterface
public interface PolygonClipper {
    /**
     * Sends each piece of {@code subject} in {@code window}, once.
     *
     * @param window at least three corners; not changed
     * @param subject at least three corners; not changed
     * @throws IllegalArgumentException if a number is not finite, the window is not convex, the
     *     subject is not simple, or the method cannot clip it; the message names the corner, its
     *     value and what is allowed
     */
    void clip(double[] window, double[] subject, PolygonSink out);
}
