package rasterlab.engine.pipeline.triangle;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;

/**
 * Threads that share out numbered items of work; the caller's thread is one of them.
 *
 * <p>The caller waits for items, not for threads: one that wakes when all is taken holds up nobody.
 * Between two tasks a thread looks for work for a moment before it sleeps. Nothing is allocated.
 */
final class WorkerTeam implements AutoCloseable {
    /** The most threads. */
    static final int MOST = 256;

    /** How long a thread looks for what it waits for before it sleeps. */
    private static final long PATIENCE_NANOS = 100_000;

    /** Looks without a look at the clock. */
    private static final int LOOKS = 32;

    private static final int NONE = -1;

    /** What is shared out. */
    interface Task {
        /**
         * @param worker 0 is the caller's thread; no two threads have one number at one time
         */
        void run(int item, int worker);
    }

    /** The one of worker k at place k; the caller's, at 0, is not kept. */
    private final Thread[] threads;

    /** 1 for each worker that sleeps or is about to. */
    private final AtomicIntegerArray asleep;

    private final AtomicInteger untaken = new AtomicInteger();
    private final AtomicInteger undone = new AtomicInteger();
    private volatile boolean closed;
    private final BooleanSupplier allDone = () -> undone.get() == 0;
    private final BooleanSupplier workOrEnd = () -> untaken.get() > 0 || closed;
    private volatile Thread waitingCaller;
    private volatile Throwable failure;

    /** Both stay as they are while an item is undone. */
    private Task task;

    private int items;

    /**
     * @param size number of threads, the caller's included
     */
    WorkerTeam(int size) {
        if (size < 1 || size > MOST)
            throw new IllegalArgumentException(
                    "threads must be from 1 to %d, got %d".formatted(MOST, size));
        threads = new Thread[size];
        asleep = new AtomicIntegerArray(size);
        for (int k = 1; k < size; k++) {
            int worker = k;
            threads[k] = new Thread(() -> serve(worker), "rasterlab-pipeline-" + worker);
            threads[k].setDaemon(true);
        }
        for (int k = 1; k < size; k++) threads[k].start();
    }

    /** Number of threads, the caller's included. */
    int size() {
        return threads.length;
    }

    /** All but the caller's. */
    Stream<Thread> threads() {
        return Arrays.stream(threads).skip(1);
    }

    /**
     * Runs items 0 to {@code count} − 1 and returns when all are done.
     *
     * @throws RuntimeException what an item threw; the rest may be left out then
     */
    void run(Task newTask, int count) {
        task = newTask;
        items = count;
        failure = null;
        undone.set(count);
        untaken.set(count);
        takeItems(0);
        if (!comesSoon(allDone)) awaitOthers();
        rethrow();
    }

    private static boolean comesSoon(BooleanSupplier here) {
        long start = System.nanoTime();
        do
            for (int look = 0; look < LOOKS; look++) {
                if (here.getAsBoolean()) return true;
                Thread.onSpinWait();
            }
        while (System.nanoTime() - start < PATIENCE_NANOS);
        return false;
    }

    private void rethrow() {
        if (failure instanceof RuntimeException thrown) throw thrown;
        if (failure instanceof Error thrown) throw thrown;
    }

    private void takeItems(int worker) {
        int item = take();
        if (item == NONE) return;
        wakeNext(worker);
        do {
            try {
                task.run(item, worker);
            } catch (RuntimeException | Error thrown) {
                failure = thrown;
                leave(untaken.getAndSet(0));
            }
            leave(1);
            item = take();
        } while (item != NONE);
    }

    /** The next item, or {@link #NONE}; who has one may read what the round is about. */
    private int take() {
        int left = untaken.get();
        while (left > 0) {
            if (untaken.compareAndSet(left, left - 1)) return items - left;
            left = untaken.get();
        }
        return NONE;
    }

    /** So many items are done or given up. */
    private void leave(int count) {
        if (undone.addAndGet(-count) > 0) return;
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
