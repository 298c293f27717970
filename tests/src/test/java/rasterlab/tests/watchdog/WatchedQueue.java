package rasterlab.tests.watchdog;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * The queue of events that tells which event keeps its thread now. There is one, and it stays: who
 * drives windows goes on posting to every queue that they ever had, and waits for an answer.
 */
final class WatchedQueue extends EventQueue {
    private static Optional<WatchedQueue> installed = Optional.empty();

    private volatile Consumer<Stay> ended = stay -> {};

    /** Events that have begun and not ended, the innermost first; on the event thread. */
    private final Deque<AWTEvent> open = new ArrayDeque<>();

    private volatile Optional<Stay> now = Optional.empty();

    private WatchedQueue() {}

    /**
     * @param ended told each stay when it is over, on the event thread
     */
    static synchronized WatchedQueue telling(Consumer<Stay> ended) {
        if (installed.isEmpty()) {
            installed = Optional.of(new WatchedQueue());
            Toolkit.getDefaultToolkit().getSystemEventQueue().push(installed.get());
        }
        installed.get().ended = ended;
        return installed.get();
    }

    /** Empty while the thread is free. */
    Optional<Stay> now() {
        return now;
    }

    @Override
    protected void dispatchEvent(AWTEvent event) {
        end();
        open.push(event);
        now = Optional.of(new Stay(event));
        try {
            super.dispatchEvent(event);
        } finally {
            end();
            open.pop();
            // The loop of a dialog may be over: the event that opened the dialog goes on.
            if (!open.isEmpty()) now = Optional.of(new Stay(open.peek()));
        }
    }

    /** Waiting for the next event, in a dialog's loop too, is no stay. */
    @Override
    public AWTEvent getNextEvent() throws InterruptedException {
        end();
        return super.getNextEvent();
    }

    private void end() {
        Optional<Stay> over = now;
        now = Optional.empty();
        over.ifPresent(
                stay -> {
                    stay.end();
                    ended.accept(stay);
                });
    }

    /** Tells nobody any more. */
    void leave() {
        ended = stay -> {};
    }
}
