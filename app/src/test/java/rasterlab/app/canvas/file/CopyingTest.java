package rasterlab.app.canvas.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.EventQueue;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.ClipboardOwner;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.function.Supplier;
import javax.swing.JPanel;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.language.Language;

@Timeout(300)
class CopyingTest {
    private static final ShownPicture PICTURE =
            new ShownPicture(
                    "picture",
                    () -> new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB),
                    () -> () -> "<svg/>",
                    Runnable::run);

    /** The messages so far, in order. */
    private final BlockingQueue<String> told = new LinkedBlockingQueue<>();

    private final HeldClipboard clipboard = new HeldClipboard();
    private final Copying copying = new Copying(() -> clipboard);

    /** A clipboard that another program gives free once for each permit. */
    private static final class HeldClipboard extends Clipboard {
        final Semaphore free = new Semaphore(0);
        final Semaphore asked = new Semaphore(0);
        final Set<Thread> askedBy = ConcurrentHashMap.newKeySet();

        HeldClipboard() {
            super("held");
        }

        @Override
        public void setContents(Transferable content, ClipboardOwner owner) {
            assertFalse(EventQueue.isDispatchThread(), "the event thread waits");
            askedBy.add(Thread.currentThread());
            asked.release();
            free.acquireUninterruptibly();
            super.setContents(content, owner);
        }

        String text() throws Exception {
            return (String) getData(DataFlavor.stringFlavor);
        }
    }

    private void fail(Throwable failure) {
        told.add(failure.getMessage());
    }

    private void copy(String text) throws Exception {
        EventQueue.invokeAndWait(() -> copying.text(text, () -> told.add(text), this::fail));
    }

    /** Waits in its second step, which makes the document, until it is let go. */
    private static final class HeldDrawing {
        final Semaphore begun = new Semaphore(0);
        final Semaphore end = new Semaphore(0);

        ShownPicture picture(Supplier<String> document) {
            return new ShownPicture(
                    "heavy",
                    PICTURE.dots(),
                    () ->
                            () -> {
                                begun.release();
                                end.acquireUninterruptibly();
                                return document.get();
                            },
                    Runnable::run);
        }
    }

    private HeldDrawing drawingThatWaits(Supplier<String> document) throws Exception {
        var held = new HeldDrawing();
        ShownPicture heavy = held.picture(document);
        EventQueue.invokeAndWait(() -> copying.svg(heavy, () -> told.add("drawing"), this::fail));
        held.begun.acquire();
        return held;
    }

    @Test
    @DisplayName("the window waits for the clipboard, or says that it copied before it did")
    void pictureIsToldWhenItIsOnTheClipboard() throws Exception {
        EventQueue.invokeAndWait(
                () ->
                        copying.picture(
                                PICTURE, dots -> told.add(dots.getWidth() + " wide"), this::fail));
        clipboard.asked.acquire();
        EventQueue.invokeAndWait(() -> assertEquals(List.of(), List.copyOf(told)));
        clipboard.free.release();
        assertEquals("3 wide", told.take());
        assertEquals(3, ((BufferedImage) clipboard.getData(DataFlavor.imageFlavor)).getWidth());
    }

    @Test
    @DisplayName("what was asked for first is copied last, since the clipboard was held")
    void whatWasAskedForLastStays() throws Exception {
        copy("first");
        clipboard.asked.acquire();
        copy("second");
        EventQueue.invokeAndWait(() -> copying.svg(PICTURE, () -> told.add("drawing"), this::fail));
        clipboard.free.release(3);
        assertEquals("drawing", told.take());
        assertEquals("<svg/>", clipboard.text());
        assertEquals(List.of(), List.copyOf(told));
        assertEquals(1, clipboard.askedBy.size(), "threads race for the clipboard");
    }

    @Test
    @DisplayName("a copy is told though another one was asked for since")
    void onlyTheLastCopyIsTold() throws Exception {
        copy("first");
        clipboard.asked.acquire();
        copy("second");
        clipboard.free.release();
        clipboard.asked.acquire();
        copy("third");
        clipboard.free.release(2);
        assertEquals("third", told.take());
        assertEquals("third", clipboard.text());
    }

    @Test
    @DisplayName("a drawing that takes long replaces the command copied after it")
    void drawingThatIsLateIsDropped() throws Exception {
        HeldDrawing heavy = drawingThatWaits(() -> "<svg/>");
        copy("command");
        heavy.end.release();
        clipboard.free.release(2);
        assertEquals("command", told.take());
        assertEquals("command", clipboard.text());
        assertEquals(1, clipboard.asked.availablePermits(), "contents that were put");
    }

    @Test
    @DisplayName("a failure is told of what is no longer wanted")
    void failureOfWhatIsDroppedIsNotTold() throws Exception {
        HeldDrawing heavy =
                drawingThatWaits(
                        () -> {
                            throw new IllegalStateException("too heavy");
                        });
        copy("command");
        heavy.end.release();
        clipboard.free.release();
        assertEquals("command", told.take());
        EventQueue.invokeAndWait(() -> assertEquals(List.of(), List.copyOf(told)));
    }

    @Test
    @DisplayName("copies that wait for the clipboard keep files from being written")
    void filesAreWrittenWhileTheClipboardIsHeld() throws Exception {
        copy("text 0");
        clipboard.asked.acquire();
        for (int i = 1; i < 12; i++) copy("text " + i);
        EventQueue.invokeAndWait(
                () ->
                        new FileWriting(new JPanel(), Language.ENGLISH, this::fail)
                                .write("title", () -> "written", told::add));
        assertEquals("written", told.take());
        clipboard.free.release(12);
        assertEquals("text 11", told.take());
    }

    @Test
    @DisplayName("the reason why nothing was copied is lost")
    void failureIsTold() throws Exception {
        var refused =
                new Copying(
                        () -> {
                            throw new IllegalStateException("held by another program");
                        });
        EventQueue.invokeAndWait(() -> refused.text("text", () -> told.add("copied"), this::fail));
        assertEquals("held by another program", told.take());
        EventQueue.invokeAndWait(() -> assertEquals(List.of(), List.copyOf(told)));
    }
}
