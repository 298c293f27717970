package rasterlab.app.exercise.statement;

import com.formdev.flatlaf.util.UIScale;
import com.github.weisj.jsvg.SVGDocument;
import com.github.weisj.jsvg.parser.LoaderContext;
import com.github.weisj.jsvg.parser.SVGLoader;
import com.github.weisj.jsvg.parser.resources.ResourcePolicy;
import com.github.weisj.jsvg.view.ViewBox;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import rasterlab.exercises.StatementPicture;

/**
 * A statement's picture on a white plate, since its author knows of no dark theme; not wider than a
 * statement usually is.
 */
final class PicturePlate {
    /** Larger pictures are made smaller, before the window's own scale. */
    private static final int WIDEST = 360;

    private static final int HIGHEST = 480;
    private static final int MARGIN = 6;

    /** A mistaken file is not to fill the memory. */
    private static final int MOST_PIXELS = 16_000_000;

    private PicturePlate() {}

    /** The image; empty where the file is broken or too large. */
    static Optional<Image> of(StatementPicture picture, String language) {
        byte[] file = picture.content(language);
        return picture.form() == StatementPicture.PictureFormat.SVG ? svg(file) : png(file);
    }

    private static Optional<Image> svg(byte[] file) {
        LoaderContext closed =
                LoaderContext.builder().externalResourcePolicy(ResourcePolicy.DENY_ALL).build();
        SVGDocument document = new SVGLoader().load(new ByteArrayInputStream(file), null, closed);
        if (document == null) return Optional.empty();
        return plate(
                document.size().width,
                document.size().height,
                g -> {
                    var box = g.getClipBounds();
                    document.render(null, g, new ViewBox(0, 0, box.width, box.height));
                });
    }

    private static Optional<Image> png(byte[] file) {
        try {
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(file));
            if (image == null) return Optional.empty();
            return plate(
                    image.getWidth(),
                    image.getHeight(),
                    g -> {
                        var box = g.getClipBounds();
                        g.drawImage(image, 0, 0, box.width, box.height, null);
                    });
        } catch (IOException broken) {
            return Optional.empty();
        }
    }

    /**
     * @param drawing fills the clip it is given, whose corner is the origin
     */
    private static Optional<Image> plate(
            double width, double height, Consumer<Graphics2D> drawing) {
        if (!(width >= 1 && height >= 1 && width * height <= MOST_PIXELS)) return Optional.empty();
        double smaller = Math.min(1, Math.min(WIDEST / width, HIGHEST / height));
        int wide = UIScale.scale((int) Math.ceil(width * smaller));
        int high = UIScale.scale((int) Math.ceil(height * smaller));
        int margin = UIScale.scale(MARGIN);
        var plate =
                new BufferedImage(wide + 2 * margin, high + 2 * margin, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = plate.createGraphics();
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, plate.getWidth(), plate.getHeight());
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
        g.translate(margin, margin);
        g.clipRect(0, 0, wide, high);
        drawing.accept(g);
        g.dispose();
        return Optional.of(plate);
    }
}
