package rasterlab.contract;

/**
 * Clips a segment by an upright rectangle, the window.
 *
 * <p>The window is closed: xmin ≤ x ≤ xmax and ymin ≤ y ≤ ymax. It may have no width or no height
 * or neither. What is left of a segment is the set of its points in the window; where that is a
 * single point, as at a touched corner, the point is left. Whether something is left is decided for
 * the exact segment between the two ends, not for a rounded one.
 *
 * <p>The part keeps the segment's direction. An end in the window stays as it is; a new end lies in
 * the window and within 10⁻¹² of the window's larger extent from the exact one (or, where the
 * window lies so far out that doubles are sparser, within a few of their steps).
 */
@FunctionalInterface
public interface SegmentClipper {
    /**
     * Sends what is left of the segment from (x0, y0) to (x1, y1), once; nothing where nothing is
     * left. Units are the same for the window and the segment.
     *
     * @param xmin left side; finite, at most {@code xmax}
     * @param ymin bottom side; finite, at most {@code ymax}
     * @param x0 any finite number, as are y0, x1 and y1
     * @throws IllegalArgumentException if a number is not finite or the sides are in the wrong
     *     order; a method may refuse, too, numbers above 10¹⁵⁰ in size, whose differences and
     *     products may not fit in a double; the message names the value and what is allowed
     */
    void clip(
            double xmin,
            double ymin,
            double xmax,
            double ymax,
            double x0,
            double y0,
            double x1,
            double y1,
            SegmentSink out);
}
