package rasterlab.app.canvas.file;

import java.awt.image.BufferedImage;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;
import rasterlab.app.canvas.DevicePixels;
import rasterlab.app.canvas.SvgDrawing;

/**
 * The picture that a lab shows, as it is copied and saved.
 *
 * @param name of its file, without an ending
 * @param dots drawn dot by dot
 * @param svg the same as a drawing
 * @param whenDrawn runs what takes the picture, as soon as it is that of the present choice
 */
public record ShownPicture(
        String name,
        Supplier<BufferedImage> dots,
        Supplier<SvgDrawing> svg,
        Consumer<Runnable> whenDrawn) {
    /** The picture that a component shows; nothing is waited for. */
    public ShownPicture(String name, JComponent shown, Supplier<SvgDrawing> svg) {
        this(name, () -> dotsOf(shown), svg, Runnable::run);
    }

    /**
     * The picture that a component shows, at the screen's own resolution, without the marks that
     * serve mouse and keyboard.
     */
    public static BufferedImage dotsOf(JComponent shown) {
        return DevicePixels.painted(
                shown.getWidth(),
                shown.getHeight(),
                DevicePixels.scale(shown),
                g -> {
                    g.setColor(shown.getBackground());
                    g.fillRect(0, 0, shown.getWidth(), shown.getHeight());
                    shown.print(g);
                });
    }
}
