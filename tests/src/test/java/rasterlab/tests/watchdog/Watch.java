package rasterlab.tests.watchdog;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/** Looks at the event thread a hundred times a second while an event keeps it. */
final class Watch implements AutoCloseable {
    /** An event may keep the thread for so long, 50 ms. */
    static final long LONG_NANOS = TimeUnit.MILLISECONDS.toNanos(50);

    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final WatchedQueue queue = WatchedQueue.installed();
    private final Thread looker = new Thread(this::run, "event watchdog");
    private List<String> faults = new ArrayList<>();
    private List<LongStay> longStays = new ArrayList<>();
    private volatile boolean closed;

    private Watch() {}

    static Watch begin() {
        var watch = new Watch();
        watch.queue.join(watch);
        watch.looker.setDaemon(true);
        watch.looker.start();
        return watch;
    }

    private void run() {
        while (!closed) {
            LockSupport.parkNanos(LOOK_NANOS);
            queue.now(this).filter(stay -> stay.age() >= LOOK_NANOS).ifPresent(this::look);
        }
    }

    private void look(Stay stay) {
        ThreadInfo seen = threads.getThreadInfo(stay.threadId(), Integer.MAX_VALUE);
        boolean still = queue.now(this).filter(now -> now == stay).isPresent();
        if (seen == null || !still) return;
        Optional<String> fault = stay.see(seen);
        synchronized (this) {
            fault.ifPresent(faults::add);
        }
    }

    /** Ends a stay, on the event thread. */
    void ended(Stay stay) {
        if (stay.nanos() <= LONG_NANOS) return;
        var longStay = new LongStay(stay.name(), stay.nanos(), stay.place());
        synchronized (this) {
            longStays.add(longStay);
        }
    }

    /** The event that keeps the event thread now; empty while it is free. */
    Optional<Stay> now() {
        return queue.now(this);
    }

    synchronized boolean hasFault() {
        return !faults.isEmpty();
    }

    /** The forbidden calls of the event thread since the last call. */
    synchronized List<String> takeFaults() {
        List<String> found = faults;
        faults = new ArrayList<>();
        return found;
    }

    /** Stays longer than 50 ms since the last call, in the order in which they ended. */
    synchronized List<LongStay> takeLongStays() {
        List<LongStay> found = longStays;
        longStays = new ArrayList<>();
        return found;
    }

    @Override
    public void close() {
        closed = true;
        queue.leave(this);
    }
}
