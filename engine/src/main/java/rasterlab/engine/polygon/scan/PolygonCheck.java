package rasterlab.engine.polygon.scan;

import rasterlab.engine.raster.Raster;

/** Refuses what no method can fill. */
final class PolygonCheck {
    /** The largest coordinate: products of two stay far below the largest double. */
    static final double FARTHEST = 1e100;

    private PolygonCheck() {}

    static void check(double[] x, double[] y, int width, int height) {
        checkSizes(x, y, width, height);
        for (int i = 0; i < x.length; i++) {
            checkCoordinate("x", i, x[i]);
            checkCoordinate("y", i, y[i]);
        }
    }

    /** Checks what does not depend on the coordinates. */
    static void checkSizes(double[] x, double[] y, int width, int height) {
        if (x.length != y.length)
            throw new IllegalArgumentException(
                    "a polygon needs as many x as y, got " + x.length + " and " + y.length);
        Raster.checkSize(width, height);
    }

    private static void checkCoordinate(String axis, int corner, double value) {
        if (!(Math.abs(value) <= FARTHEST))
            throw new IllegalArgumentException(
                    axis
                            + " of corner "
                            + corner
                            + " must be a number from -1e100 to 1e100, got "
                            + value);
    }
}
