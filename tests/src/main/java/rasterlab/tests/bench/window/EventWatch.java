package rasterlab.tests.bench.window;

import java.awt.AWTEvent;
import java.awt.EventQueue;

/** Measures how long the event thread is busy with one event. */
final class EventWatch extends EventQueue {
    private volatile long longestNanos;

    @Override
    protected void dispatchEvent(AWTEvent event) {
        long start = System.nanoTime();
        super.dispatchEvent(event);
        longestNanos = Math.max(longestNanos, System.nanoTime() - start);
    }

    /** The longest since the last call, in nanoseconds. */
    long longest() {
        long found = longestNanos;
        longestNanos = 0;
        return found;
    }

    /** Gives events back to the queue before. */
    void leave() {
        pop();
    }
}
