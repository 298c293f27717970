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
     * @param corners x and y of each corner in turn
     */
    static PolygonTask of(FillRule rule, int width, int height, double... corners) {
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
