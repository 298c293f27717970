package rasterlab.tests.watchdog;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedDeque;

/**
 * The queue of events that tells which event keeps its thread now. There is one, and it stays: who
 * drives windows goes on posting to every queue that they ever had, and waits for an answer.
 *
 * <p>The newest watch alone is told: a test of watching has one beside that of the whole run.
 */
final class WatchedQueue extends EventQueue {
    private static Optional<WatchedQueue> installed = Optional.empty();

    /** The newest first. */
    private final Deque<Watch> watches = new ConcurrentLinkedDeque<>();

    /** Events that have begun and not ended, the innermost first; on the event thread. */
    private final Deque<AWTEvent> open = new ArrayDeque<>();

    private volatile Optional<Stay> now = Optional.empty();

    private WatchedQueue() {}

    static synchronized WatchedQueue installed() {
        if (installed.isEmpty()) {
            installed = Optional.of(new WatchedQueue());
            Toolkit.getDefaultToolkit().getSystemEventQueue().push(installed.get());
        }
        return installed.get();
    }

    /** Tells a watch of events that begin from now on, until it leaves or a newer one comes. */
    void join(Watch watch) {
        watches.push(watch);
    }

    void leave(Watch watch) {
        watches.remove(watch);
    }

    /**
     * The stay of now; empty while the thread is free, and for every watch but the one that the
     * stay is told.
     */
    Optional<Stay> now(Watch watch) {
        return now.filter(stay -> stay.watch().filter(watch::equals).isPresent());
    }

    @Override
    protected void dispatchEvent(AWTEvent event) {
        end();
        open.push(event);
        now = Optional.of(begun(event));
        try {
            super.dispatchEvent(event);
        } finally {
            end();
            open.pop();
            // The loop of a dialog may be over: the event that opened the dialog goes on.
            if (!open.isEmpty()) now = Optional.of(begun(open.peek()));
        }
    }

    /** Waiting for the next event, in a dialog's loop too, is no stay. */
    @Override
    public AWTEvent getNextEvent() throws InterruptedException {
        end();
        return super.getNextEvent();
    }

    private Stay begun(AWTEvent event) {
        return new Stay(event, Optional.ofNullable(watches.peek()));
    }

    private void end() {
        Optional<Stay> over = now;
        now = Optional.empty();
        over.ifPresent(
                stay -> {
                    stay.end();
                    stay.watch().ifPresent(watch -> watch.ended(stay));
                });
    }
}
