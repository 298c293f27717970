package rasterlab.app.outcome;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.Raster;

/**
 * A picture's pixels as its file has them.
 *
 * <p>{@link BufferedImage#getRGB} takes the levels of a grey picture for amounts of light and makes
 * 188 of 128; a file's grey levels are meant as its colours' levels are.
 */
public final class FileLevels {
    private FileLevels() {}

    /**
     * Luminance (1), luminance and alpha (2), colour (3) or colour and alpha (4).
     *
     * @return how many levels a pixel has
     */
    public static int components(BufferedImage picture) {
        ColorModel model = picture.getColorModel();
        return (isGray(model) ? 1 : 3) + (model.hasAlpha() ? 1 : 0);
    }

    /**
     * Reads one row as 0xAARRGGBB, deeper levels rounded to the nearest of 255.
     *
     * @param y from the top
     * @param argb filled from {@code at} on
     */
    public static void row(BufferedImage picture, int y, int[] argb, int at) {
        int width = picture.getWidth();
        if (!isGray(picture.getColorModel())) {
            picture.getRGB(0, y, width, 1, argb, at, width);
            return;
        }
        Raster levels = picture.getRaster();
        boolean alpha = picture.getColorModel().hasAlpha();
        for (int x = 0; x < width; x++) {
            int gray = level(picture, levels.getSample(x, y, 0), 0);
            int opacity = alpha ? level(picture, levels.getSample(x, y, 1), 1) : 255;
            argb[at + x] = opacity << 24 | gray * 0x010101;
        }
    }

    private static int level(BufferedImage picture, int sample, int band) {
        int highest = (1 << picture.getColorModel().getComponentSize(band)) - 1;
        return (2 * 255 * sample + highest) / (2 * highest);
    }

    private static boolean isGray(ColorModel model) {
        return model.getColorSpace().getType() == ColorSpace.TYPE_GRAY;
    }
}
