package rasterlab.tests.bench.window;

import java.awt.AWTEvent;
import java.awt.EventQueue;

/**
 * Measures how long the event thread is busy with one event.
 *
 * <p>It stays until the process ends: Java gives a queue that gets its events back a second event
 * thread if its own one has ended meanwhile, and then some events are never seen to.
 */
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
}
