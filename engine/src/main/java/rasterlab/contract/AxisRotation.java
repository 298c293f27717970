package rasterlab.contract;

/**
 * Turns points of space about a line, counter-clockwise seen from where the direction points to.
 *
 * <p>The space is right-handed. A point on the line stays where it is. The direction may have any
 * length but 0.
 */
@FunctionalInterface
public interface AxisRotation {
    /**
     * Replaces every point by its image.
     *
     * @param through x, y, z of a point of the line
     * @param direction x, y, z of the line's direction
     * @param degrees the angle, any finite number
     * @param points x, y, z of each point, one after the other; may be empty
     * @throws IllegalArgumentException if the direction is zero, an array has a wrong length, or a
     *     number is not finite or a coordinate's magnitude above 2¹⁰⁰⁰; the message names the place
     */
    void rotate(double[] through, double[] direction, double degrees, double[] points);
}
