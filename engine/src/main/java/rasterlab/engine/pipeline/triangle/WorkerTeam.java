package rasterlab.engine.pipeline.triangle;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Threads that share out numbered items of work; the caller's thread is one of them.
 *
 * <p>Between two tasks a thread looks for work for some microseconds before it sleeps. Nothing is
 * allocated.
 */
final class WorkerTeam implements AutoCloseable {
    /** The most threads. */
    static final int MOST = 256;

    /** Looks for work before a thread sleeps, about 20 µs. */
    private static final int SPINS = 2000;

    /** What is shared out. */
    interface Task {
        /**
         * @param worker 0 is the caller's thread; no two threads have one number at one time
         */
        void run(int item, int worker);
    }

    private final Thread[] threads;
    private final AtomicInteger nextItem = new AtomicInteger();
    private final AtomicInteger busy = new AtomicInteger();
    private final Object bell = new Object();
    private volatile int round;
    private volatile boolean closed;
    private volatile Throwable failure;
    private Task task;
    private int items;

    /**
     * @param size number of threads, the caller's included
     */
    WorkerTeam(int size) {
        if (size < 1 || size > MOST)
            throw new IllegalArgumentException(
                    "threads must be from 1 to %d, got %d".formatted(MOST, size));
        threads = new Thread[size - 1];
        for (int k = 0; k < threads.length; k++) {
            int worker = k + 1;
            threads[k] = new Thread(() -> serve(worker), "rasterlab-pipeline-" + worker);
            threads[k].setDaemon(true);
            threads[k].start();
        }
    }

    int size() {
        return threads.length + 1;
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
        nextItem.set(0);
        busy.set(threads.length);
        ring();
        takeItems(0);
        for (int spin = 0; spin < SPINS && busy.get() > 0; spin++) Thread.onSpinWait();
        if (busy.get() > 0) awaitOthers();
        rethrow();
    }

    private void ring() {
        synchronized (bell) {
            round++;
            bell.notifyAll();
        }
    }

    private void rethrow() {
        if (failure instanceof RuntimeException thrown) throw thrown;
        if (failure instanceof Error thrown) throw thrown;
    }

    private void takeItems(int worker) {
        try {
            for (int item; (item = nextItem.getAndIncrement()) < items; ) task.run(item, worker);
        } catch (RuntimeException | Error thrown) {
            failure = thrown;
            nextItem.set(items);
        }
    }

    /** An interruption is kept for the caller: a frame is never left half done by it. */
    private void awaitOthers() {
        boolean interrupted = false;
        synchronized (bell) {
            while (busy.get() > 0)
                try {
                    bell.wait();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
        }
        if (interrupted) Thread.currentThread().interrupt();
    }

    private void serve(int worker) {
        int seen = 0;
        while (awaitRound(seen)) {
            seen++;
            takeItems(worker);
            if (busy.decrementAndGet() == 0)
                synchronized (bell) {
                    bell.notifyAll();
                }
        }
    }

    /** Returns false when the team is closed. */
    private boolean awaitRound(int seen) {
        for (int spin = 0; spin < SPINS && round == seen; spin++) Thread.onSpinWait();
        if (round == seen && !closed)
            synchronized (bell) {
                while (round == seen && !closed)
                    try {
                        bell.wait();
                    } catch (InterruptedException e) {
                        return false;
                    }
            }
        return !closed;
    }

    /** Ends the threads. */
    @Override
    public void close() {
        closed = true;
        ring();
    }
}
