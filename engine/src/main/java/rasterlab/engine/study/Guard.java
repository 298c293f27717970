package rasterlab.engine.study;

import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import rasterlab.engine.study.SpentTime.ThreadLook;

/**
 * Runs foreign code on a thread of its own, so that it may crash or never end.
 *
 * <p>A thread that does not end cannot be stopped from outside; it is interrupted and left behind
 * as a daemon, which does not keep the process alive.
 *
 * <p>On a busy machine a thread waits for its turn, which is no fault of its code: it is given up
 * when it has had its limit of processor time or of sleep, see {@link SpentTime}.
 */
public final class Guard {
    private Guard() {}

    /** How a call ended. */
    public sealed interface CallOutcome<T> {}

    public record Returned<T>(T value) implements CallOutcome<T> {}

    public record Failed<T>(Throwable cause) implements CallOutcome<T> {}

    public record TimedOut<T>(Duration limit) implements CallOutcome<T> {}

    /**
     * The outcome of {@code work} within {@code limit}, errors of the virtual machine included.
     *
     * @param name of the thread
     * @param limit of its processor time and its sleep together
     * @throws CancellationException when the waiting thread is interrupted
     */
    public static <T> CallOutcome<T> call(String name, Callable<T> work, Duration limit) {
        return call(name, work, limit, new Lookout());
    }

    /** Looks at a thread; loaded without what only a slow call needs. */
    static class Lookout {
        ThreadLook look(Thread thread) {
            return ThreadLook.at(thread);
        }
    }

    static <T> CallOutcome<T> call(String name, Callable<T> work, Duration limit, Lookout watch) {
        var task = new FutureTask<>(work);
        var thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
        try {
            return within(limit, task, thread, watch);
        } catch (ExecutionException e) {
            return new Failed<>(e.getCause());
        } catch (InterruptedException e) {
            task.cancel(true);
            Thread.currentThread().interrupt();
            throw new CancellationException(name + " was interrupted");
        }
    }

    private static <T> CallOutcome<T> within(
            Duration limit, FutureTask<T> task, Thread thread, Lookout watch)
            throws ExecutionException, InterruptedException {
        long start = System.nanoTime();
        long first = Math.max(SpentTime.LEAST_NANOS, limit.toNanos() / SpentTime.LOOKS);
        if (hasEnded(task, first)) return new Returned<>(task.get());
        var spent = new SpentTime(limit);
        while (true) {
            Duration passed = Duration.ofNanos(System.nanoTime() - start);
            Duration wait = spent.more(watch.look(thread), passed);
            // It may have ended while it was looked at, and a thread that has ended does not run.
            if (wait.isZero() ? task.isDone() : hasEnded(task, wait.toNanos()))
                return new Returned<>(task.get());
            if (wait.isZero()) {
                task.cancel(true);
                return new TimedOut<>(limit);
            }
        }
    }

    /** Waits until a task has ended, but no longer than that; whether it has ended. */
    private static boolean hasEnded(FutureTask<?> task, long nanos)
            throws ExecutionException, InterruptedException {
        try {
            task.get(nanos, TimeUnit.NANOSECONDS);
            return true;
        } catch (TimeoutException e) {
            return false;
        }
    }
}
