package rasterlab.app.canvas;

import java.awt.AlphaComposite;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;
import javax.swing.JComponent;
import rasterlab.engine.raster.Raster;

/** Pictures made in the screen's own dots, of which a view unit may have more than one. */
public final class DevicePixels {
    private DevicePixels() {}

    /** Device dots per view unit of the screen that shows the component; 1 off screen. */
    public static double scale(JComponent component) {
        var configuration = component.getGraphicsConfiguration();
        return configuration == null ? 1 : configuration.getDefaultTransform().getScaleX();
    }

    /** The dots of so many view units, from 1 to {@link Raster#LARGEST_SIDE}. */
    public static int count(int view, double scale) {
        return (int) Math.max(1, Math.min(Raster.LARGEST_SIDE, Math.round(view * scale)));
    }

    /**
     * A picture of so many view units.
     *
     * @param paint is given a graphics in view units
     */
    public static BufferedImage painted(
            int width, int height, double scale, Consumer<Graphics2D> paint) {
        var image =
                new BufferedImage(
                        count(width, scale), count(height, scale), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        try {
            g.scale(scale, scale);
            paint.accept(g);
        } finally {
            g.dispose();
        }
        return image;
    }

    /** Asks for smooth edges and letters, and for lines that lie where they are told to. */
    public static void smooth(Graphics2D g) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    }

    /** Puts the picture's pixels on the screen's dots one to one. */
    public static void paint(Graphics2D g, BufferedImage image) {
        AffineTransform view = g.getTransform();
        g.setTransform(
                AffineTransform.getTranslateInstance(
                        Math.round(view.getTranslateX()), Math.round(view.getTranslateY())));
        g.setComposite(AlphaComposite.Src);
        g.drawImage(image, 0, 0, null);
    }
}
