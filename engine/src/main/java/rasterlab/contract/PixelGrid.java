package rasterlab.contract;

/**
 * A picture that a method reads and writes pixel by pixel.
 *
 * <p>Columns 0 to width − 1 grow to the right, rows 0 to height − 1 grow down. A colour is any int.
 */
public interface PixelGrid {
    int width();

    int height();

    /**
     * The colour of a pixel.
     *
     * @throws IndexOutOfBoundsException if it is outside the picture
     */
    int read(int x, int y);

    /**
     * Gives a pixel a colour.
     *
     * @throws IndexOutOfBoundsException if it is outside the picture
     */
    void write(int x, int y, int color);
}
