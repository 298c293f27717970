package rasterlab.contract;

/**
 * Draws that part of a straight segment between two pixel centres which lies in a window.
 *
 * <p>The pixels are those of the whole segment, as {@link LineRasterizer} has them, that lie in the
 * window: the same ones, in the same order from (x0, y0) to (x1, y1), each once. Where none lies in
 * it, nothing is sent. x grows to the right, y down.
 */
@FunctionalInterface
public interface WindowedLineRasterizer {
    /**
     * Sends the pixels of the segment from (x0, y0) to (x1, y1) that lie in the window. Any int is
     * allowed for the ends, however far outside they are; nothing is refused.
     *
     * @param xmin the window's first column; it belongs to the window
     * @param ymin the window's first row, which does so, too
     * @param xmax its last column, at least xmin, in the window
     * @param ymax its last row, at least ymin, in the window
     * @param out receives each pixel once
     */
    void draw(int x0, int y0, int x1, int y1, int xmin, int ymin, int xmax, int ymax, Pixels out);
}
