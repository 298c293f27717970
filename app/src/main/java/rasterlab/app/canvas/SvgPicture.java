package rasterlab.app.canvas;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.function.Consumer;
import javax.swing.JComponent;
import org.apache.batik.dom.GenericDOMImplementation;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2D;
import org.apache.batik.svggen.SVGSyntax;

/**
 * Drawings as SVG documents. What a component draws is drawn at once; writing the document, which
 * takes longer, is left to whoever asks for it.
 */
public final class SvgPicture {
    private SvgPicture() {}

    /** A drawing and where it lies in a larger one. */
    private record Part(Rectangle place, Consumer<Graphics2D> drawing) {}

    /** Loads what the first drawing would take long for. On any thread. */
    public static void prepare() {
        of(
                        8,
                        8,
                        g -> {
                            g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 4));
                            g.drawString("1", 1, 7);
                            g.drawLine(0, 0, 7, 7);
                            var dot = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
                            within(
                                    new Rectangle(2, 2, 4, 4),
                                    g,
                                    part -> part.drawImage(dot, 0, 0, null));
                        })
                .document();
    }

    /**
     * The drawing of a component in view units; its pictures keep each of the dots that they have
     * on the component's screen.
     */
    public static SvgDrawing of(JComponent shown, Consumer<Graphics2D> drawing) {
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

    /** The drawings of several views on their stage, each in its place, if it is shown. */
    public static SvgDrawing of(JComponent stage, PlaneView... views) {
        var parts = new ArrayList<Part>();
        for (PlaneView view : views)
            if (view.isVisible()) parts.add(new Part(view.getBounds(), view.drawing()));
        return later(
                stage.getWidth(),
                stage.getHeight(),
                g -> parts.forEach(part -> within(part.place(), g, part.drawing())));
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
    public static SvgDrawing of(int width, int height, Consumer<Graphics2D> drawing) {
        var document =
                GenericDOMImplementation.getDOMImplementation()
                        .createDocument(SVGSyntax.SVG_NAMESPACE_URI, SVGSyntax.SVG_SVG_TAG, null);
        var context = SVGGeneratorContext.createDefault(document);
        var pictures = new PngInSvg();
        context.setImageHandler(pictures);
        var graphics = new SVGGraphics2D(context, false);
        graphics.setSVGCanvasSize(new Dimension(width, height));
        drawing.accept(graphics);
        return () -> written(graphics, pictures);
    }

    /**
     * @param drawing draws when the document is asked for, on that thread
     */
    public static SvgDrawing later(int width, int height, Consumer<Graphics2D> drawing) {
        return () -> of(width, height, drawing).document();
    }

    private static String written(SVGGraphics2D graphics, PngInSvg pictures) {
        pictures.pack();
        var text = new StringWriter();
        try {
            graphics.stream(text, true);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return text.toString();
    }
}
