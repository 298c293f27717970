package rasterlab.engine.transform;

/** What every method demands of the numbers it is given. */
public final class Coordinates {
    /** The largest magnitude of a coordinate in double: sums and turns of such never overflow. */
    public static final double LARGEST = 0x1p1000;

    /** The same for methods that compute in float. */
    public static final double LARGEST_FLOAT = 0x1p120;

    private Coordinates() {}

    /**
     * @param dimension numbers per point
     * @throws IllegalArgumentException naming the first point that is not finite or too far out, or
     *     if there is half a point
     */
    public static void require(double[] points, int dimension, double largest) {
        if (points.length % dimension != 0)
            throw new IllegalArgumentException(
                    "points must have %d numbers each, got %d numbers in all"
                            .formatted(dimension, points.length));
        for (int i = 0; i < points.length; i++)
            if (!(Math.abs(points[i]) <= largest))
                throw outside(
                        "points[" + i / dimension + "]." + "xyz".charAt(i % dimension),
                        points[i],
                        largest);
    }

    /** The same for one vector of three numbers. */
    public static void requireVector(String name, double[] vector, double largest) {
        if (vector.length != 3)
            throw new IllegalArgumentException(name + " must have 3 numbers, got " + vector.length);
        for (int i = 0; i < 3; i++)
            if (!(Math.abs(vector[i]) <= largest))
                throw outside(name + "." + "xyz".charAt(i), vector[i], largest);
    }

    private static IllegalArgumentException outside(String place, double value, double largest) {
        return new IllegalArgumentException(
                "%s must be a finite number from %s to %s, got %s"
                        .formatted(place, -largest, largest, value));
    }
}
