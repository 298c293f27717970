package rasterlab.app.canvas.file;

import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.work.LatestOnly;

/**
 * Puts pictures, drawings and texts on a clipboard. Used on the event thread, which never waits for
 * the clipboard: another program may hold it for long. What was asked for last stays, whoever asked
 * for it; what was asked for before, and is not copied yet, is dropped without a word.
 */
public final class Copying {
    /** The program's only one, as the system has only one clipboard. */
    private static final Copying SYSTEM =
            new Copying(() -> Toolkit.getDefaultToolkit().getSystemClipboard());

    private final Supplier<Clipboard> clipboard;
    private final LatestOnly<Step, Runnable> steps =
            new LatestOnly<>(
                    "clipboard",
                    (step, cancelled) -> taken(step),
                    (step, then) -> EventQueue.invokeLater(() -> finish(step.asked(), then)),
                    Throwable::printStackTrace);

    /**
     * The number of the latest request, raised when what was asked for before is no longer wanted.
     */
    private volatile int request;

    /**
     * The work that is done off the event thread for a request.
     *
     * @param work answers what is run on the event thread afterwards
     * @param onFailure told what the work threw, on the event thread
     */
    private record Step(int asked, Supplier<Runnable> work, Consumer<Throwable> onFailure) {}

    /**
     * @param clipboard asked for on another thread
     */
    Copying(Supplier<Clipboard> clipboard) {
        this.clipboard = clipboard;
    }

    /** The way to the clipboard that the system's programs share. */
    public static Copying toSystem() {
        return SYSTEM;
    }

    /**
     * @param copied run when the text is on the clipboard
     * @param onFailure told why it could not be copied, such as for want of a clipboard
     */
    public void text(String text, Runnable copied, Consumer<Throwable> onFailure) {
        put(begin(), () -> new StringSelection(text), copied, onFailure);
    }

    /**
     * Copies what a lab shows dot by dot.
     *
     * @param copied told the picture when it is on the clipboard
     * @param onFailure told why it could not be copied
     */
    public void picture(
            ShownPicture picture, Consumer<BufferedImage> copied, Consumer<Throwable> onFailure) {
        int asked = begin();
        picture.whenDrawn()
                .accept(
                        () -> {
                            if (asked != request) return;
                            BufferedImage dots = picture.dots().get();
                            put(
                                    asked,
                                    () -> new PictureSelection(dots),
                                    () -> copied.accept(dots),
                                    onFailure);
                        });
    }

    /** Copies it as a drawing. */
    public void svg(ShownPicture picture, Runnable copied, Consumer<Throwable> onFailure) {
        int asked = begin();
        Runnable drawn = () -> drawing(asked, picture, copied, onFailure);
        Supplier<Runnable> prepared =
                () -> {
                    SvgPicture.prepare();
                    return () -> picture.whenDrawn().accept(drawn);
                };
        steps.ask(new Step(asked, prepared, onFailure));
    }

    private void drawing(
            int asked, ShownPicture picture, Runnable copied, Consumer<Throwable> onFailure) {
        if (asked != request) return;
        SvgDrawing drawing = picture.svg().get();
        put(asked, () -> new SvgSelection(drawing.document()), copied, onFailure);
    }

    private int begin() {
        return ++request;
    }

    private void put(
            int asked,
            Supplier<Transferable> content,
            Runnable copied,
            Consumer<Throwable> onFailure) {
        Supplier<Runnable> work =
                () -> {
                    Transferable made = content.get();
                    if (asked == request) clipboard.get().setContents(made, null);
                    return copied;
                };
        steps.ask(new Step(asked, work, onFailure));
    }

    /** The action after the step: the one that it asks for, or word of its failure. */
    private static Runnable taken(Step step) {
        try {
            return step.work().get();
        } catch (RuntimeException | Error e) {
            return () -> step.onFailure().accept(e);
        }
    }

    private void finish(int asked, Runnable then) {
        if (asked == request) then.run();
    }
}
