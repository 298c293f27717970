package rasterlab.exercises.searching;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Keeps the last find of a search, which so is not lost when the search comes to no end; what such
 * a search would tell later nobody hears.
 */
final class LastFind implements SearchListener {
    private final SearchListener listener;
    private Optional<Find> last = Optional.empty();
    private boolean closed;

    LastFind(SearchListener listener) {
        this.listener = listener;
    }

    /** Keeps a find that is told only if nothing better comes. */
    synchronized void keep(Find find) {
        last = Optional.of(find);
    }

    @Override
    public synchronized void tried(long inputs) {
        if (!closed) listener.tried(inputs);
    }

    @Override
    public synchronized void found(Find find) {
        last = Optional.of(find);
        if (!closed) listener.found(find);
    }

    @Override
    public synchronized void simpler(Find find) {
        last = Optional.of(find);
        if (!closed) listener.simpler(find);
    }

    private synchronized Optional<Find> close() {
        closed = true;
        return last;
    }

    /**
     * The result of a search, or what it has found so far when that time is over: its thread is
     * interrupted and left behind as a daemon. A busy machine gets no more time.
     *
     * @throws CancellationException when the waiting thread is interrupted
     */
    Optional<Find> within(Callable<Optional<Find>> search, Duration limit) {
        var task = new FutureTask<>(search);
        var thread = new Thread(task, "search");
        thread.setDaemon(true);
        thread.start();
        try {
            return task.get(limit.toNanos(), TimeUnit.NANOSECONDS);
        } catch (TimeoutException e) {
            Optional<Find> found = close();
            task.cancel(true);
            return found;
        } catch (ExecutionException e) {
            if (e.getCause() instanceof RuntimeException thrown) throw thrown;
            if (e.getCause() instanceof Error thrown) throw thrown;
            throw new AssertionError("a search throws nothing else", e.getCause());
        } catch (InterruptedException e) {
            close();
            task.cancel(true);
            Thread.currentThread().interrupt();
            throw new CancellationException("search was interrupted");
        }
    }
}
