package rasterlab.app.canvas;

import java.awt.image.RenderedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import javax.imageio.ImageIO;
import org.apache.batik.svggen.ImageHandlerBase64Encoder;

/** Keeps a picture in an SVG document, dot for dot, as a PNG. */
final class PngInSvg extends ImageHandlerBase64Encoder {
    @Override
    public void encodeImage(RenderedImage picture, OutputStream out) {
        try {
            ImageIO.write(picture, "png", out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
