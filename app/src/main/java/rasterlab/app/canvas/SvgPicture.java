package rasterlab.app.canvas;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.function.Consumer;
import org.apache.batik.dom.GenericDOMImplementation;
import org.apache.batik.svggen.SVGGraphics2D;
import org.apache.batik.svggen.SVGSyntax;

/** Drawings as SVG documents. */
public final class SvgPicture {
    private SvgPicture() {}

    /**
     * @param width in pixels
     * @param height in pixels
     */
    public static String of(int width, int height, Consumer<Graphics2D> drawing) {
        var document =
                GenericDOMImplementation.getDOMImplementation()
                        .createDocument(SVGSyntax.SVG_NAMESPACE_URI, SVGSyntax.SVG_SVG_TAG, null);
        var graphics = new SVGGraphics2D(document);
        graphics.setSVGCanvasSize(new Dimension(width, height));
        drawing.accept(graphics);
        var text = new StringWriter();
        try {
            graphics.stream(text, true);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return text.toString();
    }
}
