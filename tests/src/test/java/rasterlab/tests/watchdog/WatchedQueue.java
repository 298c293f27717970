package rasterlab.tests.watchdog;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.Consumer;

/** The queue of events that tells which event keeps its thread now. */
final class WatchedQueue extends EventQueue {
    private final Consumer<Stay> ended;

    /** Events that have begun and not ended, the innermost first; on the event thread. */
    private final Deque<AWTEvent> open = new ArrayDeque<>();

    private volatile Optional<Stay> now = Optional.empty();

    /**
     * @param ended told each stay when it is over, on the event thread
     */
    WatchedQueue(Consumer<Stay> ended) {
        this.ended = ended;
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

    /** Gives events back to the queue before. */
    void leave() {
        pop();
    }
}
