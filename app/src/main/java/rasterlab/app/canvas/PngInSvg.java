package rasterlab.app.canvas;

import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.RenderedImage;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.apache.batik.svggen.ImageHandlerBase64Encoder;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2DIOException;
import org.w3c.dom.Element;

/**
 * Keeps pictures in an SVG document, dot for dot, as PNG; packs them when the document is written.
 */
final class PngInSvg extends ImageHandlerBase64Encoder {
    private record Kept(RenderedImage picture, Element place, SVGGeneratorContext context) {}

    private final List<Kept> pictures = new ArrayList<>();

    /** Keeps the picture as it is now. */
    @Override
    public void handleHREF(RenderedImage picture, Element place, SVGGeneratorContext context) {
        pictures.add(new Kept(copy(picture), place, context));
    }

    private static BufferedImage copy(RenderedImage picture) {
        ColorModel colors = picture.getColorModel();
        WritableRaster dots =
                colors.createCompatibleWritableRaster(picture.getWidth(), picture.getHeight());
        picture.copyData(dots);
        return new BufferedImage(colors, dots, colors.isAlphaPremultiplied(), null);
    }

    /** Packs the pictures into the document; on any thread. */
    void pack() {
        for (Kept each : pictures)
            try {
                super.handleHREF(each.picture(), each.place(), each.context());
                if (enlarged(each))
                    each.place().setAttributeNS(null, "image-rendering", "pixelated");
            } catch (SVGGraphics2DIOException e) {
                throw new UncheckedIOException(e);
            }
        pictures.clear();
    }

    /** Whose dots are seen one by one, which viewers would smooth away. */
    private static boolean enlarged(Kept kept) {
        String width = kept.place().getAttributeNS(null, "width");
        return !width.isEmpty() && Double.parseDouble(width) > kept.picture().getWidth();
    }

    @Override
    public void encodeImage(RenderedImage picture, OutputStream out) {
        try {
            ImageIO.write(picture, "png", out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
