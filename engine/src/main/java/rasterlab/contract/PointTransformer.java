package rasterlab.contract;

/**
 * Sends points through a list of matrices, the first one first, and divides by H at the end.
 *
 * <p>Points are rows of d numbers, d being 2 or 3; {@code [x y 1] · M} or {@code [x y z 1] · M}
 * with matrices of (d + 1)² cells. The last number of the product is H. The image is what stands
 * before it, divided by H. Homogeneous points {@code [x y h]} and {@code [x y z h]} go the same way
 * with their h in the place of the 1: the point is (x/h, y/h, z/h), and h = 0 is the point at
 * infinity in the direction (x, y, z), whose image by a perspective is a vanishing point. H = 0 is
 * a point at infinity: it has no image, all its coordinates become NaN. H &lt; 0 lies behind the
 * eye of a central projection: the division is done all the same, and mirrors the point; clip
 * before dividing where that must not be seen.
 */
@FunctionalInterface
public interface PointTransformer {
    /**
     * Replaces every point by its image.
     *
     * @param dimension d, 2 or 3
     * @param matrices each with its (d + 1)² cells row by row; none is the identity
     * @param points d numbers each, one after the other; may be empty
     * @param h the homogeneous coordinate of each point, 1 for a plain one; receives H
     * @throws IllegalArgumentException if an array has a wrong length, a number is not finite or,
     *     for a method in float, out of float's range, or a product or an image is too large or so
     *     small that digits would be lost; the message names the place
     */
    void transform(int dimension, double[][] matrices, double[] points, double[] h);
}
