package rasterlab.app.exercise.outcome;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import rasterlab.engine.raster.PixelMark;

/**
 * A case's picture as it was made, each pixel of its raster as a square of dots, and the raster
 * itself, in which a mark is one pixel of its colour: smaller squares would lose the mark's shape,
 * and with it the mark.
 *
 * @param dots of the picture across each pixel
 * @param raster one dot for each pixel
 */
record RasterPicture(BufferedImage picture, int dots, BufferedImage raster)
        implements PaintedPicture {
    /** Marks have their shape from so many view units for each pixel on. */
    private static final int SHAPED = 6;

    /** Dots are sharp, though not all of one width, from so many view units for each on. */
    private static final int SHARP = 3;

    /** Sum over the channels, from 0 to 765, within which a dot has a mark's colour. */
    private static final int ALIKE = 60;

    /**
     * @param pixels of the raster, across and down
     * @param dots at least 1
     */
    static RasterPicture of(BufferedImage picture, Dimension pixels, int dots) {
        var raster = new BufferedImage(pixels.width, pixels.height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < pixels.height; y++)
            for (int x = 0; x < pixels.width; x++)
                raster.setRGB(x, y, color(picture, x * dots, y * dots, dots));
        return new RasterPicture(picture, dots, raster);
    }

    /** The mark's, where there is one in that square; else that of its middle. */
    private static int color(BufferedImage picture, int left, int top, int dots) {
        for (int y = top; y < top + dots; y++)
            for (int x = left; x < left + dots; x++)
                if (isMark(picture.getRGB(x, y))) return PixelMark.ARGB;
        return picture.getRGB(left + dots / 2, top + dots / 2);
    }

    private static boolean isMark(int rgb) {
        var dot = new Color(rgb);
        Color mark = PixelMark.COLOR;
        return Math.abs(dot.getRed() - mark.getRed())
                        + Math.abs(dot.getGreen() - mark.getGreen())
                        + Math.abs(dot.getBlue() - mark.getBlue())
                < ALIKE;
    }

    @Override
    public void paint(Graphics2D g, Rectangle part, Rectangle place) {
        boolean shaped = place.width >= SHAPED * part.width;
        int each = shaped ? dots : 1;
        int across = each * part.width;
        boolean sharp = place.width % across == 0 || place.width >= SHARP * across;
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION,
                sharp
                        ? RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR
                        : RenderingHints.VALUE_INTERPOLATION_BICUBIC);
        g.drawImage(
                shaped ? picture : raster,
                place.x,
                place.y,
                place.x + place.width,
                place.y + place.height,
                each * part.x,
                each * part.y,
                each * (part.x + part.width),
                each * (part.y + part.height),
                null);
    }
}
