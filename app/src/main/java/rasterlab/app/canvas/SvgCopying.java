package rasterlab.app.canvas;

import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingWorker;

/** Puts what a lab shows on the clipboard as an SVG document. Used on the event thread. */
final class SvgCopying {
    private final ShownPicture picture;
    private final Consumer<Throwable> onFailure;
    private SwingWorker<?, Void> running;

    /** Raised when what was asked for before is no longer wanted. */
    private int request;

    /**
     * @param onFailure told what could not be copied, on any thread
     */
    SvgCopying(ShownPicture picture, Consumer<Throwable> onFailure) {
        this.picture = picture;
        this.onFailure = onFailure;
    }

    void copy() {
        cancel();
        int asked = request;
        inBackground(
                () -> {
                    SvgPicture.prepare();
                    return picture.whenDrawn();
                },
                whenDrawn -> whenDrawn.accept(() -> take(asked)));
    }

    private void take(int asked) {
        if (asked != request) return;
        SvgDrawing drawing = picture.svg().get();
        inBackground(drawing::document, this::put);
    }

    /** The system's clipboard may be waited for longer than the window should be. */
    private void put(String document) {
        inBackground(
                () -> {
                    Copying.svg(document, onFailure);
                    return document;
                },
                copied -> {});
    }

    /** What is copied after it stays on the clipboard. */
    void cancel() {
        request++;
        if (running != null) running.cancel(false);
    }

    private <T> void inBackground(Supplier<T> work, Consumer<T> then) {
        var worker =
                new SwingWorker<T, Void>() {
                    @Override
                    protected T doInBackground() {
                        return work.get();
                    }

                    @Override
                    protected void done() {
                        if (!isCancelled()) finish(this, then);
                    }
                };
        running = worker;
        worker.execute();
    }

    private <T> void finish(SwingWorker<T, Void> finished, Consumer<T> then) {
        try {
            then.accept(finished.get());
        } catch (ExecutionException e) {
            onFailure.accept(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
