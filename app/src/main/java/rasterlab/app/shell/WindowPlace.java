package rasterlab.app.shell;

import java.awt.Dimension;
import java.awt.Rectangle;

/**
 * How large the window is at first and at least, and where a window of an earlier run stands, in
 * view units.
 *
 * @param screen what windows may fill
 * @param scale of the type and the display, 1 for the usual ones
 */
record WindowPlace(Rectangle screen, float scale) {
    private static final Dimension LEAST = new Dimension(900, 600);
    private static final Dimension FIRST = new Dimension(1280, 800);

    Dimension first() {
        return smaller(scaled(FIRST), screen.getSize());
    }

    /** Large type asks for more room, but for no more than a small projector has. */
    Dimension least() {
        return smaller(smaller(scaled(LEAST), FIRST), screen.getSize());
    }

    /** The place of an earlier run; where its window was smaller than may be, on the screen. */
    Rectangle again(Rectangle earlier) {
        Dimension least = least();
        if (earlier.width >= least.width && earlier.height >= least.height) return earlier;
        int width = Math.max(earlier.width, least.width);
        int height = Math.max(earlier.height, least.height);
        int right = screen.x + Math.max(0, screen.width - width);
        int lower = screen.y + Math.max(0, screen.height - height);
        return new Rectangle(
                Math.max(screen.x, Math.min(earlier.x, right)),
                Math.max(screen.y, Math.min(earlier.y, lower)),
                width,
                height);
    }

    private Dimension scaled(Dimension size) {
        return new Dimension(Math.round(scale * size.width), Math.round(scale * size.height));
    }

    private static Dimension smaller(Dimension one, Dimension other) {
        return new Dimension(Math.min(one.width, other.width), Math.min(one.height, other.height));
    }
}
