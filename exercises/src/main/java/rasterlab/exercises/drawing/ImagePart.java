package rasterlab.exercises.drawing;

import java.awt.image.BufferedImage;
import rasterlab.engine.raster.PixelWindow;

/**
 * The part of an image that a picture shows, enlarged by a whole factor.
 *
 * @param shown the columns and rows, from 0
 * @param factor pixels of the picture for one of the image, in each direction
 */
record ImagePart(PixelWindow shown, int factor) {
    /** Pixels that a picture's longer side has at most. */
    private static final int LONGEST = 512;

    private static final int LARGEST_FACTOR = 32;

    /** Pixels that its shorter side should have: less of a strip is shown, but larger. */
    private static final int SHORTEST = 16;

    /**
     * A part of at most so many pixels each way around (x, y), as large as a picture can be.
     *
     * @param most a power of 2 up to {@link #LONGEST}
     */
    static ImagePart around(PixelWindow whole, int x, int y, int most) {
        PixelWindow shown = whole.around(x, y, most, most);
        int longest = (int) Math.max(shown.width(), shown.height());
        int factor = Math.max(1, Math.min(LARGEST_FACTOR, LONGEST / longest));
        boolean strip = Math.min(shown.width(), shown.height()) * factor < SHORTEST;
        return strip && most > SHORTEST
                ? around(whole, x, y, most / 2)
                : new ImagePart(shown, factor);
    }

    int width() {
        return (int) shown.width() * factor;
    }

    int height() {
        return (int) shown.height() * factor;
    }

    /** The left edge of a column in the picture. */
    int left(int column) {
        return (column - shown.xmin()) * factor;
    }

    /** The upper edge of a row in the picture. */
    int top(int row) {
        return (row - shown.ymin()) * factor;
    }

    /** Hands over the color 0xRRGGBB of a pixel of the image at a pixel of the picture. */
    interface Colors {
        int rgb(int column, int row, int x, int y);
    }

    /** A picture of these colors. */
    BufferedImage drawn(Colors colors) {
        var picture = new BufferedImage(width(), height(), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height(); y++)
            for (int x = 0; x < width(); x++)
                picture.setRGB(
                        x,
                        y,
                        colors.rgb(shown.xmin() + x / factor, shown.ymin() + y / factor, x, y));
        return picture;
    }
}
