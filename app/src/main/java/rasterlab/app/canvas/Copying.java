package rasterlab.app.canvas;

import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingWorker;

/**
 * Puts pictures, drawings and texts on the system's clipboard. Used on the event thread, which
 * never waits for the clipboard: another program may hold it for long.
 */
public final class Copying {
    private final Supplier<Clipboard> clipboard;
    private final Consumer<Throwable> onFailure;

    /** Held while one content is put on the clipboard, so that the one asked for last stays. */
    private final Object turn = new Object();

    /** Raised when what was asked for before is no longer wanted. */
    private volatile int request;

    /**
     * @param onFailure told on the event thread what could not be copied, such as for want of a
     *     clipboard
     */
    public Copying(Consumer<Throwable> onFailure) {
        this(() -> Toolkit.getDefaultToolkit().getSystemClipboard(), onFailure);
    }

    /**
     * @param clipboard asked for on another thread
     */
    Copying(Supplier<Clipboard> clipboard, Consumer<Throwable> onFailure) {
        this.clipboard = clipboard;
        this.onFailure = onFailure;
    }

    /**
     * @param copied run when the text is on the clipboard
     */
    public void text(String text, Runnable copied) {
        put(begin(), () -> new StringSelection(text), copied);
    }

    /**
     * Copies what a lab shows dot by dot.
     *
     * @param copied told the picture when it is on the clipboard
     */
    void picture(ShownPicture picture, Consumer<BufferedImage> copied) {
        int asked = begin();
        picture.whenDrawn()
                .accept(
                        () -> {
                            if (asked != request) return;
                            BufferedImage dots = picture.dots().get();
                            put(asked, () -> new PictureSelection(dots), () -> copied.accept(dots));
                        });
    }

    /** Copies it as a drawing. */
    void svg(ShownPicture picture, Runnable copied) {
        int asked = begin();
        inBackground(
                asked,
                () -> {
                    SvgPicture.prepare();
                    return picture.whenDrawn();
                },
                whenDrawn -> whenDrawn.accept(() -> drawing(asked, picture, copied)));
    }

    private void drawing(int asked, ShownPicture picture, Runnable copied) {
        if (asked != request) return;
        SvgDrawing drawing = picture.svg().get();
        put(asked, () -> new SvgSelection(drawing.document()), copied);
    }

    private int begin() {
        return ++request;
    }

    private void put(int asked, Supplier<Transferable> content, Runnable copied) {
        inBackground(
                asked,
                () -> {
                    Transferable made = content.get();
                    synchronized (turn) {
                        if (asked == request) clipboard.get().setContents(made, null);
                    }
                    return made;
                },
                made -> copied.run());
    }

    private <T> void inBackground(int asked, Supplier<T> work, Consumer<T> then) {
        new SwingWorker<T, Void>() {
            @Override
            protected T doInBackground() {
                return work.get();
            }

            @Override
            protected void done() {
                try {
                    T made = get();
                    if (asked == request) then.accept(made);
                } catch (ExecutionException e) {
                    onFailure.accept(e.getCause());
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        }.execute();
    }
}
