package rasterlab.app.plan.bill;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.work.LatestOnly;
import rasterlab.app.canvas.work.Listeners;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.plan.Planner;

/**
 * Finds the bill of the picture that is shown, in the background; the last one is kept meanwhile.
 *
 * <p>Used on one thread, that of the executor it is given.
 */
public final class PictureBills implements AutoCloseable {
    private final LatestOnly<RenderRequest, Optional<PictureBill>> work;
    private final Listeners<PictureBills> listeners = new Listeners<>();
    private Optional<RenderRequest> asked = Optional.empty();
    private Optional<PictureBill> bill = Optional.empty();
    private boolean current;

    /**
     * @param events runs what it is given on the one thread that uses this, in order
     * @param onFailure told what counting threw, on any thread
     */
    public PictureBills(Executor events, Consumer<Throwable> onFailure) {
        var planner = new Planner();
        work =
                new LatestOnly<>(
                        "bill",
                        (request, cancelled) -> PictureBill.of(request, planner, cancelled),
                        (request, found) -> events.execute(() -> accept(request, found)),
                        onFailure);
    }

    /** Asks for the bill of a picture. */
    public void ask(RenderRequest request) {
        asked = Optional.of(request);
        work.ask(request);
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
    public Optional<PictureBill> bill() {
        return bill;
    }

    /** Whether the bill is of the picture that is shown, not of an earlier one. */
    public boolean current() {
        return current;
    }

    /** Tells the listener of each bill, and when it becomes old; the answer ends that. */
    public Runnable listen(Consumer<PictureBills> listener) {
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

    private void accept(RenderRequest request, Optional<PictureBill> found) {
        if (asked.filter(newest -> newest == request).isEmpty()) return;
        bill = found;
        current = true;
        listeners.tell(this);
    }
}
