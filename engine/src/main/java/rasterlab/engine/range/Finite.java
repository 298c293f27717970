package rasterlab.engine.range;

/** Refuses numbers that are not numbers. */
public final class Finite {
    private Finite() {}

    /**
     * Passes if the value is finite.
     *
     * @param name what it is
     * @throws IllegalArgumentException naming it
     */
    public static void require(String name, double value) {
        if (!Double.isFinite(value))
            throw new IllegalArgumentException(name + " must be finite, got " + value);
    }

    /**
     * Passes if all values are finite.
     *
     * @param name what they are, in the singular
     * @throws IllegalArgumentException naming the first that is not, by its place
     */
    public static void require(String name, double... values) {
        for (int i = 0; i < values.length; i++)
            if (!Double.isFinite(values[i]))
                throw new IllegalArgumentException(
                        name + " " + i + " must be finite, got " + values[i]);
    }

    /**
     * Passes if there are as many x as y, at least {@code least}, all finite.
     *
     * @param name what the points are, in the singular
     * @throws IllegalArgumentException naming the count or the first place that is wrong
     */
    public static void requirePoints(String name, double[] x, double[] y, int least) {
        if (x.length != y.length)
            throw new IllegalArgumentException(
                    name + "s have " + x.length + " x but " + y.length + " y; give as many");
        if (x.length < least)
            throw new IllegalArgumentException(
                    "at least " + least + " " + name + "s are needed, got " + x.length);
        for (int i = 0; i < x.length; i++)
            if (!Double.isFinite(x[i]) || !Double.isFinite(y[i]))
                throw new IllegalArgumentException(
                        name + " " + i + " must be finite, got (" + x[i] + ", " + y[i] + ")");
    }
}
