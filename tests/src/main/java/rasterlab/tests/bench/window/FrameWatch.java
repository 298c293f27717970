package rasterlab.tests.bench.window;

import java.awt.Toolkit;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.RepaintManager;

/**
 * Notes when a new picture has been painted and has reached the display. A repaint of the same
 * picture is no frame.
 */
final class FrameWatch extends RepaintManager {
    private final List<Long> frames = new ArrayList<>();
    private Supplier<Object> shown = () -> null;
    private Object last;

    /**
     * Forgets the frames so far. On the event thread.
     *
     * @param picture what is shown, another object when it is another picture
     */
    void begin(Supplier<Object> picture) {
        shown = picture;
        last = picture.get();
        frames.clear();
    }

    /**
     * When the frames since the last call were on the display, in nanoseconds. On the event thread.
     */
    List<Long> frames() {
        var found = List.copyOf(frames);
        frames.clear();
        return found;
    }

    @Override
    public void paintDirtyRegions() {
        super.paintDirtyRegions();
        Object now = shown.get();
        if (now == last) return;
        last = now;
        Toolkit.getDefaultToolkit().sync();
        frames.add(System.nanoTime());
    }
}
