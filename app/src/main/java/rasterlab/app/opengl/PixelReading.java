package rasterlab.app.opengl;

import java.util.Optional;
import rasterlab.app.language.Texts;
import rasterlab.engine.raster.Raster;

/**
 * The colours of one pixel in both pictures, as the stage writes them.
 *
 * @param openGl levels of red, green and blue, or a dash where there is no picture
 */
record PixelReading(int x, int y, String openGl, String software) {
    /** The reading at a pixel; empty where there is no such pixel yet. */
    static Optional<PixelReading> at(OpenGlLabState.OpenGlPictures pictures, int x, int y) {
        return pictures.software()
                .filter(raster -> raster.contains(x, y))
                .map(
                        raster ->
                                new PixelReading(
                                        x,
                                        y,
                                        pictures.openGl()
                                                .filter(other -> other.contains(x, y))
                                                .map(other -> levels(other, x, y))
                                                .orElse("–"),
                                        levels(raster, x, y)));
    }

    /**
     * @param key of a text with places for x, y and the two colours
     */
    String text(Texts texts, String key) {
        return texts.text(key, x, y, openGl, software);
    }

    private static String levels(Raster raster, int x, int y) {
        int argb = raster.argb(x, y);
        return (argb >> 16 & 255) + " " + (argb >> 8 & 255) + " " + (argb & 255);
    }
}
