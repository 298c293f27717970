package rasterlab.app.cli.render;

import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import rasterlab.app.cli.console.Console;

/**
 * Says after two, four, eight … seconds that a picture is still being made, and stops it when
 * interrupted.
 */
final class RenderProgress implements BooleanSupplier {
    private static final long SECOND = 1_000_000_000L;

    private final Console console;
    private final Thread waiting = Thread.currentThread();
    private final long start = System.nanoTime();

    /** The seconds after which it is said next. */
    private final AtomicLong next = new AtomicLong(2);

    RenderProgress(Console console) {
        this.console = console;
    }

    /** Whether to stop; the renderer asks on any of its threads. */
    @Override
    public boolean getAsBoolean() {
        tell((System.nanoTime() - start) / SECOND);
        return waiting.isInterrupted();
    }

    /** Says how many seconds have passed, if it is time to. */
    void tell(long seconds) {
        long due = next.get();
        if (seconds >= due && next.compareAndSet(due, 2 * Long.highestOneBit(seconds)))
            console.tell("rendering", seconds);
    }
}
