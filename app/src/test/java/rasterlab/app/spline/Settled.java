package rasterlab.app.spline;

import java.util.concurrent.ConcurrentLinkedQueue;
import rasterlab.app.canvas.Settling;

/** The one thread of a model under test: what the model's background work hands over. */
final class Settled {
    final ConcurrentLinkedQueue<Runnable> events = new ConcurrentLinkedQueue<>();

    /** Waits for a model's background work and hands it to the model. */
    void settle(Settling model) {
        try {
            model.settle();
        } catch (InterruptedException e) {
            throw new AssertionError("the test was interrupted", e);
        }
        for (Runnable event = events.poll(); event != null; event = events.poll()) event.run();
    }
}
