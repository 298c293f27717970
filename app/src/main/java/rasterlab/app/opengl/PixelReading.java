package rasterlab.app.opengl;

import java.util.Optional;
import rasterlab.app.language.Texts;
import rasterlab.engine.raster.Raster;

/** The colours of one pixel in both pictures, as the stage writes them. */
final class PixelReading {
    private final OpenGlLabState.Pictures pictures;
    private final Texts texts;

    PixelReading(OpenGlLabState.Pictures pictures, Texts texts) {
        this.pictures = pictures;
        this.texts = texts;
    }

    /** Empty where there is no such pixel yet. */
    Optional<String> at(int x, int y) {
        return pictures.software()
                .filter(raster -> raster.contains(x, y))
                .map(
                        raster ->
                                texts.text(
                                        "reading",
                                        x,
                                        y,
                                        pictures.openGl()
                                                .filter(other -> other.contains(x, y))
                                                .map(other -> levels(other, x, y))
                                                .orElse("–"),
                                        levels(raster, x, y)));
    }

    private static String levels(Raster raster, int x, int y) {
        int argb = raster.argb(x, y);
        return (argb >> 16 & 255) + " " + (argb >> 8 & 255) + " " + (argb & 255);
    }
}
