package rasterlab.app.plan.bill;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Listeners;

/**
 * Finds the bill of the picture that is shown, in the background; the last one is kept meanwhile.
 *
 * <p>Used on one thread, that of the executor it is given.
 *
 * @param <Q> a picture
 * @param <B> its bill
 */
public final class Bills<Q, B> implements AutoCloseable {
    private final LatestOnly<Q, Optional<B>> work;
    private final Listeners<Bills<Q, B>> listeners = new Listeners<>();
    private Optional<Q> asked = Optional.empty();
    private Optional<B> bill = Optional.empty();
    private boolean current;

    /**
     * @param name of the thread
     * @param found makes the bill of a picture; empty for one that has none
     * @param events runs what it is given on the one thread that uses this, in order
     * @param onFailure told what making a bill threw, on any thread
     */
    public Bills(
            String name,
            LatestOnly.LongWork<Q, Optional<B>> found,
            Executor events,
            Consumer<Throwable> onFailure) {
        work =
                new LatestOnly<>(
                        name,
                        found,
                        (picture, made) -> events.execute(() -> accept(picture, made)),
                        onFailure);
    }

    /** Asks for the bill of a picture. */
    public void ask(Q picture) {
        asked = Optional.of(picture);
        work.ask(picture);
    }

    /** Drops what is being counted: another picture is shown. */
    public void cancel() {
        asked = Optional.empty();
        work.cancel();
        if (!current) return;
        current = false;
        listeners.tell(this);
    }

    /** The newest bill; empty before there is one, and for pictures that have none. */
    public Optional<B> bill() {
        return bill;
    }

    /** Whether the bill is of the picture that is shown, not of an earlier one. */
    public boolean current() {
        return current;
    }

    /** Tells the listener of each bill, and when it becomes old; the answer ends that. */
    public Runnable listen(Consumer<Bills<Q, B>> listener) {
        return listeners.add(listener);
    }

    /** Waits until what was asked so far is found or dropped. Any other thread. */
    public void settle() throws InterruptedException {
        work.settle();
    }

    @Override
    public void close() {
        work.close();
    }

    private void accept(Q picture, Optional<B> found) {
        if (asked.filter(newest -> newest == picture).isEmpty()) return;
        bill = found;
        current = true;
        listeners.tell(this);
    }
}
