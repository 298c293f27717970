package rasterlab.contract;

/**
 * Where a raster method sends the pixels it lights, in drawing order.
 *
 * <p>The receiver decides what a pixel becomes: a dot in a picture, an entry in a recording, a
 * count.
 */
@FunctionalInterface
public interface Pixels {
    /**
     * Lights one pixel.
     *
     * @param x pixel column, grows to the right
     * @param y pixel row, grows down
     */
    void plot(int x, int y);
}
