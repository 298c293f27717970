package rasterlab.engine.pipeline.fast;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;

/**
 * Threads that share out numbered items of work; the caller's thread is one of them.
 *
 * <p>The caller waits for items, not for threads: one that wakes when all is taken holds up nobody.
 * Between two tasks a thread looks for work for a moment before it sleeps. Nothing is allocated.
 */
final class WorkerTeam implements AutoCloseable {
    /** The most threads. */
    static final int MOST = 256;

    /**
     * How long a thread looks for what it waits for before it sleeps: about two wakings, so that it
     * stays awake between the stages of a frame.
     */
    private static final long PATIENCE_NANOS = 100_000;

    /** Looks without a look at the clock. */
    private static final int LOOKS = 32;

    private static final int NONE = -1;

    /** The work that is shared out. */
    interface SharedTask {
        /**
         * @param worker 0 is the caller's thread; no two threads have one number at one time
         */
        void run(int item, int worker);
    }

    /** Worker k is at place k; the caller, worker 0, is not kept. */
    /** The threads of workers 1 and up; none at 0, where the caller works. */
    final Thread[] threads;

    /** 1 for each worker that sleeps or is about to. */
    private final AtomicIntegerArray asleep;

    /** Items that nobody has; below 0 where several threads asked for one at once. */
    private final AtomicInteger untaken = new AtomicInteger();

    /** Items that nobody has told to be done: never fewer than are untaken. */
    private final AtomicInteger undone = new AtomicInteger();

    private volatile boolean closed;
    private final BooleanSupplier allDone = () -> undone.get() == 0;
    private final BooleanSupplier workOrEnd = () -> untaken.get() > 0 || closed;
    private volatile Thread waitingCaller;
    private volatile Throwable failure;

    /** Stays as it is while an item is undone, and so do the items. */
    private SharedTask task;

    private int items;

    /**
     * @param size number of threads, the caller's included
     */
    WorkerTeam(int size) {
        checkSize(size);
        threads = new Thread[size];
        asleep = new AtomicIntegerArray(size);
        for (int k = 1; k < size; k++) {
            int worker = k;
            threads[k] = new Thread(() -> serve(worker), "rasterlab-pipeline-" + worker);
            threads[k].setDaemon(true);
        }
        for (int k = 1; k < size; k++) threads[k].start();
    }

    static void checkSize(int size) {
        if (size < 1 || size > MOST)
            throw new IllegalArgumentException(
                    "threads must be from 1 to %d, got %d".formatted(MOST, size));
    }

    /**
     * Runs items 0 to {@code count} − 1 and returns when all are done.
     *
     * @throws RuntimeException what an item threw; the rest may be left out then
     * @throws IllegalStateException where the team is closed
     */
    void run(SharedTask newTask, int count) {
        if (closed) throw new IllegalStateException("the threads have ended");
        task = newTask;
        items = count;
        failure = null;
        undone.set(count); // First: a thread that comes late from an earlier task may take at once.
        untaken.set(count);
        takeItems(0);
        if (!comesSoon(allDone)) awaitOthers();
        rethrow();
    }

    private static boolean comesSoon(BooleanSupplier condition) {
        long start = System.nanoTime();
        do
            for (int look = 0; look < LOOKS; look++) {
                if (condition.getAsBoolean()) return true;
                Thread.onSpinWait();
            }
        while (System.nanoTime() - start < PATIENCE_NANOS);
        return false;
    }

    private void rethrow() {
        if (failure instanceof RuntimeException thrown) throw thrown;
        if (failure instanceof Error thrown) throw thrown;
        if (failure != null) throw new IllegalStateException(failure);
    }

    /** Counts the finished items once, at the end, so that fewer threads write to one place. */
    private void takeItems(int worker) {
        int item = take();
        if (item == NONE) return;
        wakeNext(worker);
        int done = 0;
        do {
            try {
                task.run(item, worker);
            } catch (Throwable thrown) {
                failure = thrown;
                done += Math.max(0, untaken.getAndSet(0));
            }
            done++;
            item = take();
        } while (item != NONE);
        tell(done);
    }

    /** The next item, or {@link #NONE}; who has one may read what the round is about. */
    private int take() {
        if (untaken.get() <= 0) return NONE;
        int left = untaken.getAndDecrement();
        return left > 0 ? items - left : NONE;
    }

    /** Counts items that are done or given up, and wakes the caller after the last. */
    private void tell(int done) {
        if (undone.addAndGet(-done) > 0) return;
        Thread caller = waitingCaller;
        if (caller != null) LockSupport.unpark(caller);
    }

    /**
     * Wakes up to two others, who wake two each: of many threads none spends long on it.
     *
     * <p>Those of worker k are 2k + 1 and 2k + 2, as in a heap.
     */
    private void wakeNext(int worker) {
        int end = Math.min(2 * worker + 3, Math.min(threads.length, items));
        for (int next = 2 * worker + 1; next < end && untaken.get() > 0; next++) wake(next);
    }

    private void wake(int worker) {
        if (asleep.get(worker) == 1 && asleep.compareAndSet(worker, 1, 0))
            LockSupport.unpark(threads[worker]);
    }

    /** An interruption is kept for the caller: a frame is never left half done by it. */
    private void awaitOthers() {
        boolean interrupted = false;
        waitingCaller = Thread.currentThread();
        while (undone.get() > 0) {
            LockSupport.park(this);
            interrupted |= Thread.interrupted();
        }
        waitingCaller = null;
        if (interrupted) Thread.currentThread().interrupt();
    }

    private void serve(int worker) {
        while (awaitItems(worker)) takeItems(worker);
    }

    /** Returns false when the team is closed. */
    private boolean awaitItems(int worker) {
        if (!comesSoon(workOrEnd)) {
            asleep.set(worker, 1);
            while (!workOrEnd.getAsBoolean() && asleep.get(worker) == 1) {
                LockSupport.park(this);
                Thread.interrupted(); // Else no park would last; what ends a worker is closing.
            }
            asleep.set(worker, 0);
        }
        return !closed;
    }

    /** Ends the threads. */
    @Override
    public void close() {
        closed = true;
        for (int k = 1; k < threads.length; k++) LockSupport.unpark(threads[k]);
    }
}
