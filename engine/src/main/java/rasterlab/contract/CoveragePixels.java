package rasterlab.contract;

/** Where an anti-aliasing method sends the pixels it touches, in drawing order. */
@FunctionalInterface
public interface CoveragePixels {
    /**
     * Lights one pixel in part.
     *
     * @param x pixel column, grows to the right
     * @param y pixel row, grows down
     * @param coverage 1 to 255, 255 being wholly covered
     */
    void plot(int x, int y, int coverage);
}
