package rasterlab.engine.transform;

/** Checks what every method demands of the numbers it is given. */
public final class Coordinates {
    /** The largest magnitude of a coordinate in double: sums and turns of such never overflow. */
    public static final double LARGEST = 0x1p1000;

    /** Checks the same for methods that compute in float. */
    public static final double LARGEST_FLOAT = 0x1p120;

    private static final double SMALLEST_FLOAT = 0x1p-100;

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

    /**
     * Checks the same for methods that compute in float: a coordinate may also not be so small that
     * a float is 0 or has lost digits.
     */
    public static void requireFloat(double[] points, int dimension) {
        require(points, dimension, LARGEST_FLOAT);
        for (int i = 0; i < points.length; i++)
            if (points[i] != 0 && Math.abs(points[i]) < SMALLEST_FLOAT)
                throw new IllegalArgumentException(
                        "points[%d].%s must be 0 or at least %s in magnitude for a float, got %s"
                                .formatted(
                                        i / dimension,
                                        "xyz".charAt(i % dimension),
                                        SMALLEST_FLOAT,
                                        points[i]));
    }

    /** Checks the same for one vector of three numbers. */
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
