package rasterlab.tests.bench.window;

import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * A mouse that holds a place of a picture and goes round in a circle, telling its place as often as
 * a usual mouse does.
 */
final class Drag {
    private static final int EVENTS_PER_SECOND = 125;
    private static final double ROUNDS_PER_SECOND = 0.5;

    private final Component told;
    private final Point from;
    private final int radius;

    /**
     * @param told the window, or a part with a window of its own, whose mouse it is
     * @param from where the button is pressed, in view units of what is told
     * @param radius of the circle, which begins there, in view units
     */
    Drag(Component told, Point from, int radius) {
        this.told = told;
        this.from = from;
        this.radius = radius;
    }

    /** The part of that name that is shown. */
    static Component named(Container root, String name) {
        for (Component child : root.getComponents()) {
            if (!child.isShowing()) continue;
            if (name.equals(child.getName())) return child;
            if (child instanceof Container inner) {
                Component found = named(inner, name);
                if (found != null) return found;
            }
        }
        return null;
    }

    /** Drags for so long and brings back what it holds. Not on the event thread. */
    void run(double seconds) {
        post(MouseEvent.MOUSE_PRESSED, from);
        long start = System.nanoTime();
        long step = TimeUnit.SECONDS.toNanos(1) / EVENTS_PER_SECOND;
        long events = (long) (seconds * EVENTS_PER_SECOND);
        for (long k = 0; k < events; k++) {
            double angle = 2 * Math.PI * ROUNDS_PER_SECOND * k / EVENTS_PER_SECOND;
            var at =
                    new Point(
                            (int) Math.round(from.x + radius * (Math.cos(angle) - 1)),
                            (int) Math.round(from.y + radius * Math.sin(angle)));
            post(MouseEvent.MOUSE_DRAGGED, at);
            long next = start + (k + 1) * step;
            while (System.nanoTime() < next) LockSupport.parkNanos(next - System.nanoTime());
        }
        post(MouseEvent.MOUSE_DRAGGED, from);
        post(MouseEvent.MOUSE_RELEASED, from);
    }

    private void post(int kind, Point at) {
        boolean moved = kind == MouseEvent.MOUSE_DRAGGED;
        Toolkit.getDefaultToolkit()
                .getSystemEventQueue()
                .postEvent(
                        new MouseEvent(
                                told,
                                kind,
                                System.currentTimeMillis(),
                                InputEvent.BUTTON1_DOWN_MASK,
                                at.x,
                                at.y,
                                moved ? 0 : 1,
                                false,
                                moved ? MouseEvent.NOBUTTON : MouseEvent.BUTTON1));
    }
}
