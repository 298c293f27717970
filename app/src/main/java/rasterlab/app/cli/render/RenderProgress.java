package rasterlab.app.cli.render;

import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import rasterlab.app.cli.console.Console;

/** Says every two seconds that a picture is still being made, and stops it when interrupted. */
final class RenderProgress implements BooleanSupplier {
    private static final long EVERY = 2_000_000_000L;

    private final Console console;
    private final Thread waiting = Thread.currentThread();
    private final long start = System.nanoTime();
    private final AtomicLong told = new AtomicLong();

    RenderProgress(Console console) {
        this.console = console;
    }

    /** Whether to stop; the renderer asks on any of its threads. */
    @Override
    public boolean getAsBoolean() {
        long passed = (System.nanoTime() - start) / EVERY;
        long before = told.get();
        if (passed > before && told.compareAndSet(before, passed))
            console.tell("rendering", passed * EVERY / 1_000_000_000L);
        return waiting.isInterrupted();
    }
}
