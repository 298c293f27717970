package rasterlab.engine.clip;

import rasterlab.engine.range.Finite;

/** The sides of an upright rectangle. */
public final class RectangleSides {
    private RectangleSides() {}

    /**
     * @throws IllegalArgumentException if a side is not finite or lies beyond its opposite
     */
    public static void requireOrdered(double xmin, double ymin, double xmax, double ymax) {
        requireOrdered("xmin", xmin, "xmax", xmax);
        requireOrdered("ymin", ymin, "ymax", ymax);
    }

    private static void requireOrdered(String lowName, double low, String highName, double high) {
        Finite.require(lowName, low);
        Finite.require(highName, high);
        if (low > high)
            throw new IllegalArgumentException(
                    lowName + " must be at most " + highName + ", got " + low + " > " + high);
    }
}
