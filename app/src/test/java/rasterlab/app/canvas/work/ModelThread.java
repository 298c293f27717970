package rasterlab.app.canvas.work;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;

/** The one thread of models under test, which runs what they hand over when it is told to. */
public final class ModelThread implements Executor {
    private final Queue<Runnable> handed = new ConcurrentLinkedQueue<>();

    @Override
    public void execute(Runnable event) {
        handed.add(event);
    }

    /** Waits for a model's background work and hands it to the model. */
    public void settle(Settling model) {
        try {
            model.settle();
        } catch (InterruptedException e) {
            throw new AssertionError("the test was interrupted", e);
        }
        runAll();
    }

    /** Runs what is handed over already. */
    public void runAll() {
        for (Runnable event = handed.poll(); event != null; event = handed.poll()) event.run();
    }

    /** Runs the one event that is handed over and no other. */
    public void runOne() {
        handed.remove().run();
    }
}
