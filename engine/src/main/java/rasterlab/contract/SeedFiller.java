package rasterlab.contract;

/**
 * Gives the region around a pixel another colour.
 *
 * <p>The region is all pixels of the seed's colour that can be reached from the seed without
 * leaving that colour, by steps to the side, up and down (connectivity 4) or diagonally as well
 * (connectivity 8: such a fill passes a gap between two pixels that touch at a corner only). The
 * picture's edge bounds every region. Where the region has the wanted colour already, nothing
 * changes and the method returns.
 */
@FunctionalInterface
public interface SeedFiller {
    /**
     * Fills the region of the pixel (x, y).
     *
     * @param picture each pixel of the region is written once, others never
     * @param with the new colour
     * @param connectivity 4 or 8
     * @throws IllegalArgumentException if the seed is outside the picture, or the connectivity is
     *     another number; the message names the value and the range
     */
    void fill(PixelGrid picture, int x, int y, int with, int connectivity);
}
