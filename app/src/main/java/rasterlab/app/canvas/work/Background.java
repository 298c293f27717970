package rasterlab.app.canvas.work;

import java.io.IOException;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;

/**
 * One piece of work at a time on a thread of its own, which can be given up; used on the event
 * thread.
 */
public final class Background implements AutoCloseable {
    /** Work that may be interrupted. */
    @FunctionalInterface
    public interface Task {
        /**
         * @param tell runs what it is given on the event thread, unless the work is given up
         * @return what is to be done with the result, on the event thread
         */
        Runnable run(Consumer<Runnable> tell) throws IOException, InterruptedException;
    }

    private final Executor events;
    private final Consumer<Throwable> onFailure;
    private final ExecutorService worker;

    /** Counts the pieces of work, so that a late word of one given up is not heard. */
    private int number;

    private Future<?> running;

    /**
     * @param onFailure told what is neither an answer nor a failure of input or output
     */
    public Background(String threadName, Executor events, Consumer<Throwable> onFailure) {
        this.events = events;
        this.onFailure = onFailure;
        worker =
                Executors.newSingleThreadExecutor(
                        work -> {
                            var thread = new Thread(work, threadName);
                            thread.setDaemon(true);
                            return thread;
                        });
    }

    /**
     * @param failed told that the work could not be done; on the event thread
     * @param ended run on the event thread before the result is used, whatever it is
     */
    public void begin(Task task, Runnable ended, Consumer<IOException> failed) {
        int mine = ++number;
        running = worker.submit(() -> run(task, mine, ended, failed));
    }

    private void run(Task task, int mine, Runnable ended, Consumer<IOException> failed) {
        Runnable after = () -> {};
        try {
            after = task.run(news -> tell(mine, news));
        } catch (IOException e) {
            after = () -> failed.accept(e);
        } catch (InterruptedException | CancellationException givenUp) {
            return;
        } catch (RuntimeException | Error e) {
            onFailure.accept(e);
        }
        Runnable last = after;
        tell(
                mine,
                () -> {
                    ended.run();
                    last.run();
                });
    }

    private void tell(int mine, Runnable news) {
        events.execute(
                () -> {
                    if (mine == number) news.run();
                });
    }

    /** Gives up the work; nothing more is heard of it. */
    public void cancel() {
        number++;
        if (running != null) running.cancel(true);
    }

    /**
     * Gives up the work and ends the thread.
     *
     * @param last run when the work has ended
     */
    public void close(Runnable last) {
        cancel();
        worker.execute(last);
        worker.shutdown();
    }

    @Override
    public void close() {
        close(() -> {});
    }
}
