package rasterlab.engine.study;

import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import java.util.function.Supplier;
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
        return call(name, work, limit, SpentTime.ThreadLook::at);
    }

    /**
     * @param watch looks at the thread, once in a while
     */
    static <T> CallOutcome<T> call(
            String name, Callable<T> work, Duration limit, Function<Thread, ThreadLook> watch) {
        var task = new FutureTask<>(work);
        var thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
        try {
            return within(limit, task, () -> watch.apply(thread));
        } catch (ExecutionException e) {
            return new Failed<>(e.getCause());
        } catch (InterruptedException e) {
            task.cancel(true);
            Thread.currentThread().interrupt();
            throw new CancellationException(name + " was interrupted");
        }
    }

    private static <T> CallOutcome<T> within(
            Duration limit, FutureTask<T> task, Supplier<ThreadLook> watch)
            throws ExecutionException, InterruptedException {
        long start = System.nanoTime();
        var spent = new SpentTime(limit);
        Duration wait = spent.first();
        while (true) {
            try {
                return new Returned<>(task.get(wait.toNanos(), TimeUnit.NANOSECONDS));
            } catch (TimeoutException e) {
                Duration passed = Duration.ofNanos(System.nanoTime() - start);
                wait = spent.more(watch.get(), passed);
            }
            // It may have ended while it was looked at, and a thread that has ended does not run.
            if (wait.isZero() && task.isDone()) return new Returned<>(task.get());
            if (wait.isZero()) {
                task.cancel(true);
                return new TimedOut<>(limit);
            }
        }
    }
}
