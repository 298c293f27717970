package rasterlab.app.canvas;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.function.Consumer;
import javax.swing.JComponent;
import org.apache.batik.dom.GenericDOMImplementation;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2D;
import org.apache.batik.svggen.SVGSyntax;

/** Drawings as SVG documents. */
public final class SvgPicture {
    private SvgPicture() {}

    /**
     * What a component draws in view units; its pictures keep each of the dots that they have on
     * the component's screen.
     */
    public static String of(JComponent shown, Consumer<Graphics2D> drawing) {
        double scale = DevicePixels.scale(shown);
        return of(
                DevicePixels.count(shown.getWidth(), scale),
                DevicePixels.count(shown.getHeight(), scale),
                g -> {
                    g.scale(scale, scale);
                    g.setFont(shown.getFont());
                    drawing.accept(g);
                });
    }

    /** What several views have on the stage that they are on, each in its place, if it is shown. */
    public static String of(JComponent stage, PlaneView... views) {
        return of(
                stage.getWidth(),
                stage.getHeight(),
                g -> {
                    for (PlaneView view : views)
                        if (view.isVisible()) within(view.getBounds(), g, view::draw);
                });
    }

    /** Draws one part of a picture, with its own origin and cut by its edges. */
    public static void within(Rectangle place, Graphics2D g, Consumer<Graphics2D> drawing) {
        var part = (Graphics2D) g.create(place.x, place.y, place.width, place.height);
        drawing.accept(part);
        part.dispose();
    }

    /**
     * @param width in pixels
     * @param height in pixels
     */
    public static String of(int width, int height, Consumer<Graphics2D> drawing) {
        var document =
                GenericDOMImplementation.getDOMImplementation()
                        .createDocument(SVGSyntax.SVG_NAMESPACE_URI, SVGSyntax.SVG_SVG_TAG, null);
        var context = SVGGeneratorContext.createDefault(document);
        context.setImageHandler(new PngInSvg());
        var graphics = new SVGGraphics2D(context, false);
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
