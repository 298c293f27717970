package rasterlab.app.opengl;

import java.awt.Container;
import java.awt.EventQueue;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.function.Supplier;
import rasterlab.app.canvas.work.Background;

/**
 * Brings OpenGL's window to its place once all that takes long is done on another thread: the
 * model's first picture, which loads the driver, and what AWT and OpenGL need of each other. Used
 * on the event thread.
 */
final class GlWindow implements AutoCloseable {
    private final OpenGlLabModel model;
    private final Container place;
    private final Runnable failed;
    private final Supplier<GlCanvas> made;
    private final Background background;
    private Optional<GlCanvas> canvas = Optional.empty();
    private boolean coming;
    private volatile CountDownLatch waiting = new CountDownLatch(0);

    /**
     * Announces the window to the model; {@link #open} opens it.
     *
     * @param place whose picture the window covers
     * @param made makes the window, on any thread
     * @param failed told that there can be none
     */
    GlWindow(OpenGlLabModel model, Container place, Supplier<GlCanvas> made, Runnable failed) {
        this.model = model;
        this.place = place;
        this.failed = failed;
        this.made = made;
        background =
                new Background(
                        "opengl window",
                        EventQueue::invokeLater,
                        cause -> EventQueue.invokeLater(this::fail));
        model.attach();
    }

    /** Opens the window soon, unless it is open or coming. */
    void open() {
        if (coming) return;
        coming = true;
        waiting = new CountDownLatch(1);
        background.begin(tell -> prepared(), () -> {}, e -> fail());
    }

    private Runnable prepared() throws InterruptedException {
        model.settle();
        GlCanvas ready = made.get();
        return () -> put(ready);
    }

    private void put(GlCanvas ready) {
        canvas = Optional.of(ready);
        place.add(ready);
        place.revalidate();
        waiting.countDown();
    }

    /**
     * Where libraries of the system are missing, the picture is made without a window, or it is
     * said why not.
     */
    private void fail() {
        waiting.countDown();
        failed.run();
    }

    void drawIfStale() {
        canvas.ifPresent(GlCanvas::drawIfStale);
    }

    /** Waits until the window is there if it is coming. Any other thread. */
    void settle() throws InterruptedException {
        waiting.await();
    }

    /** Takes the window away, also while it is still coming. */
    @Override
    public void close() {
        background.close();
        canvas.ifPresent(place::remove);
        canvas = Optional.empty();
        waiting.countDown();
        model.detach();
    }
}
