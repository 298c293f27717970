package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.EventQueue;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.ClipboardOwner;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class CopyingTest {
    private static final ShownPicture PICTURE =
            new ShownPicture(
                    "picture",
                    () -> new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB),
                    () -> () -> "<svg/>",
                    Runnable::run);

    /** What was told, in order. */
    private final BlockingQueue<String> told = new LinkedBlockingQueue<>();

    private final HeldClipboard clipboard = new HeldClipboard();
    private final Copying copying =
            new Copying(() -> clipboard, failure -> told.add(failure.getMessage()));

    /** A clipboard that another program gives free once for each permit. */
    private static final class HeldClipboard extends Clipboard {
        final Semaphore free = new Semaphore(0);
        final Semaphore asked = new Semaphore(0);

        HeldClipboard() {
            super("held");
        }

        @Override
        public void setContents(Transferable content, ClipboardOwner owner) {
            assertFalse(EventQueue.isDispatchThread(), "the event thread waits");
            asked.release();
            free.acquireUninterruptibly();
            super.setContents(content, owner);
        }

        String text() throws Exception {
            return (String) getData(DataFlavor.stringFlavor);
        }
    }

    @Test
    @DisplayName("the window waits for the clipboard, or says that it copied before it did")
    void pictureIsToldWhenItIsOnTheClipboard() throws Exception {
        EventQueue.invokeAndWait(
                () -> copying.picture(PICTURE, dots -> told.add(dots.getWidth() + " wide")));
        clipboard.asked.acquire();
        EventQueue.invokeAndWait(() -> assertEquals(List.of(), List.copyOf(told)));
        clipboard.free.release();
        assertEquals("3 wide", told.take());
        assertEquals(3, ((BufferedImage) clipboard.getData(DataFlavor.imageFlavor)).getWidth());
    }

    @Test
    @DisplayName("what was asked for first is copied last, since the clipboard was held")
    void whatWasAskedForLastStays() throws Exception {
        EventQueue.invokeAndWait(() -> copying.text("first", () -> told.add("first")));
        clipboard.asked.acquire();
        EventQueue.invokeAndWait(() -> copying.text("second", () -> told.add("second")));
        EventQueue.invokeAndWait(() -> copying.svg(PICTURE, () -> told.add("drawing")));
        clipboard.free.release(3);
        assertEquals("drawing", told.take());
        assertEquals("<svg/>", clipboard.text());
        assertEquals(List.of(), List.copyOf(told));
    }

    @Test
    @DisplayName("the reason why nothing was copied is lost")
    void failureIsTold() throws Exception {
        var refused =
                new Copying(
                        () -> {
                            throw new IllegalStateException("held by another program");
                        },
                        failure -> told.add(failure.getMessage()));
        EventQueue.invokeAndWait(() -> refused.text("text", () -> told.add("copied")));
        assertEquals("held by another program", told.take());
        EventQueue.invokeAndWait(() -> assertEquals(List.of(), List.copyOf(told)));
    }
}
