package rasterlab.contract;

/**
 * Turns points of the plane, x to the right and y up, about the origin, counter-clockwise, several
 * times in a row.
 *
 * <p>After n turns by θ a point stands where one turn by n·θ puts it; how far a method's rounding
 * drifts from there is what it is judged by.
 */
@FunctionalInterface
public interface PlaneRotation {
    /** The most turns in a row. */
    int MOST_TIMES = 10_000_000;

    /**
     * Replaces every point by its image.
     *
     * @param degrees the angle θ of one turn, any finite number
     * @param times how many turns, 0 to {@link #MOST_TIMES}
     * @param points x, y of each point, one after the other; may be empty
     * @throws IllegalArgumentException if an argument is out of range, half a point is given, a
     *     coordinate is not finite or its magnitude above 2¹⁰⁰⁰ (2¹²⁰ for a method in float), or
     *     the method cannot turn by this angle; the message names the place
     */
    void rotate(double degrees, int times, double[] points);
}
