package rasterlab.app.cli.run;

import java.time.Duration;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;
import rasterlab.app.outcome.Complaint;

/** Waits for a method, but not for ever. */
final class Watch {
    private final Duration limit;

    /**
     * @param limit the longest wait, wall time
     */
    Watch(Duration limit) {
        this.limit = limit;
    }

    /**
     * Runs the work on a thread of its own, which does not keep the program alive.
     *
     * @param name of the method, for the message
     * @throws Complaint if the work refuses ({@link IllegalArgumentException}), crashes, or does
     *     not end in time
     */
    <T> T call(String name, Supplier<T> work) {
        var task = new FutureTask<>(work::get);
        var thread = new Thread(task, "method " + name);
        thread.setDaemon(true);
        thread.start();
        try {
            return task.get(limit.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
            task.cancel(true);
            throw Complaint.gaveUp(
                    name + " did not end within " + limit.toSeconds() + " s and was given up");
        } catch (InterruptedException e) {
            task.cancel(true);
            Thread.currentThread().interrupt();
            throw Complaint.gaveUp(name + " was interrupted");
        } catch (ExecutionException e) {
            throw explained(name, e.getCause());
        }
    }

    private static Complaint explained(String name, Throwable cause) {
        if (cause instanceof Complaint complaint) return complaint;
        if (cause instanceof IllegalArgumentException refusal)
            return Complaint.refused(name + " refuses: " + refusal.getMessage());
        return Complaint.gaveUp(name + " crashed: " + cause);
    }
}
