package rasterlab.contract;

/**
 * Puts polygons in the order in which to paint them, the farthest first.
 *
 * <p>A polygon is flat and convex, given by x, y, z of its corners, at least three, which go round
 * either way. It is seen from both sides and covers whatever was painted before it. An order is
 * right if at no place of the picture, that is, on no ray from the eye, a farther polygon is
 * painted over a nearer one; one that is nearer by less than 10⁻¹² of its distance is level, and of
 * those either may come first. A polygon whose plane holds the eye, or misses it by less than 10⁻¹²
 * of the largest coordinate, covers nothing and may come anywhere.
 *
 * <p>Where polygons overlap in a circle or pass through each other no order of whole ones is right:
 * then some are cut into pieces, which together cover their polygon once.
 *
 * <p>Every polygon is at least as wide as 10⁻⁶ of the largest coordinate in size, of corners and
 * eye, and as far from the eye; its width is its area by the longest way between its corners.
 *
 * <p>The eye looks nowhere in particular: polygons may be all around it. Two kinds may be refused:
 * those of which one reaches behind the eye, by a method that orders them by depth, and those that
 * need more than 1,000,000 pieces. An exercise may ask for the first kind, too.
 */
@FunctionalInterface
public interface DepthOrder {
    /**
     * Sends every polygon, whole or in convex pieces, back to front. Polygons that hide nothing of
     * each other may come in any order, and more may be cut than has to be.
     *
     * @param polygons any finite coordinates, in any unit; not to be changed
     * @param eye x, y, z
     * @throws IllegalArgumentException if a number is not finite, a polygon is not flat, convex and
     *     of some area, one is narrower or nearer to the eye than 10⁻⁶ of the largest coordinate,
     *     or they are refused as said above; the message names place, value and what is allowed
     */
    void order(double[][] polygons, double[] eye, PieceSink out);
}
