package rasterlab.engine.polygon.scan;

import rasterlab.contract.FillRule;

/**
 * A polygon and the picture to fill it in: an input of topic {@code polygon-fill}.
 *
 * @param x columns of the corners, not to be changed
 * @param y rows of the corners, not to be changed
 * @param width of the picture, in pixels
 * @param height of the picture, in pixels
 */
public record PolygonTask(double[] x, double[] y, FillRule rule, int width, int height) {
    /**
     * @throws IllegalArgumentException if x and y are not as many, or no picture has that size
     */
    public PolygonTask {
        PolygonCheck.checkSizes(x, y, width, height);
    }

    /**
     * @param corners x and y of each corner in turn
     * @throws IllegalArgumentException if a y is missing
     */
    static PolygonTask of(FillRule rule, int width, int height, double... corners) {
        if (corners.length % 2 != 0)
            throw new IllegalArgumentException(
                    "corners need an even count of numbers, got " + corners.length);
        var x = new double[corners.length / 2];
        var y = new double[corners.length / 2];
        for (int i = 0; i < x.length; i++) {
            x[i] = corners[2 * i];
            y[i] = corners[2 * i + 1];
        }
        return new PolygonTask(x, y, rule, width, height);
    }

    @Override
    public String toString() {
        return x.length + " corners, " + rule + ", in " + width + "×" + height + " pixels";
    }
}
