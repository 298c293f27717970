package rasterlab.app.canvas;

import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;

/**
 * What a lab shows, as it is copied and saved.
 *
 * @param name of its file, without an ending
 * @param shown what is drawn dot by dot
 * @param svg the same as a drawing
 * @param whenDrawn runs what takes the picture, as soon as it is that of the present choice
 */
public record ShownPicture(
        String name,
        Supplier<? extends JComponent> shown,
        Supplier<String> svg,
        Consumer<Runnable> whenDrawn) {
    /** A picture that is never waited for. */
    public ShownPicture(String name, JComponent shown, Supplier<String> svg) {
        this(name, () -> shown, svg, Runnable::run);
    }
}
