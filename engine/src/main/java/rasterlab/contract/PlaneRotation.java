package rasterlab.contract;

/**
 * Turns points of the plane, x to the right and y up, about the origin, counter-clockwise, several
 * times in a row.
 *
 * <p>After n turns by θ a point stands where one turn by n·θ puts it. Rounding moves it from there:
 * in each coordinate by up to (n + 4)·{@link #DRIFT} of the larger |coordinate| that the point had
 * at first. What is farther off is an error: so are sines in float, or those of whole degrees alone
 * where θ lies between two of them.
 */
@FunctionalInterface
public interface PlaneRotation {
    /** The most turns in a row. */
    int MOST_TIMES = 10_000_000;

    /** The most that rounding moves a point in one turn, as a share of its larger |coordinate|. */
    double DRIFT = 0x1p-51;

    /**
     * Replaces every point by its image.
     *
     * @param degrees the angle θ of one turn, any finite number, negative ones being clockwise
     * @param times how many turns n, 0 to {@link #MOST_TIMES}
     * @param points x, y of each point, one after the other; may be empty
     * @throws IllegalArgumentException if an argument is out of range, half a point is given, a
     *     coordinate is not finite or its magnitude above 2¹⁰⁰⁰ (2¹²⁰ for a method in float); the
     *     message names the place
     */
    void rotate(double degrees, int times, double[] points);
}
