package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JScrollPane;
import javax.swing.TransferHandler;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.opengl.call.GlCall;
import rasterlab.app.opengl.state.Setting;
import rasterlab.app.shell.settings.LabTheme;

class CallLogTest {
    private static final String LONG = "glLightfv(GL_LIGHT0, GL_AMBIENT, {0.15, 0.15, 0.15, 1})";
    private static final List<GlCall> CALLS =
            List.of(call("glEnable(GL_LIGHTING)"), call(LONG), call("glFlush()"));

    private final AtomicReference<CallLog> log = new AtomicReference<>();
    private final AtomicReference<JScrollPane> scroll = new AtomicReference<>();

    private static GlCall call(String text) {
        return new GlCall(Optional.empty(), text, objects -> {});
    }

    @BeforeEach
    void show() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    log.set(new CallLog(Texts.of("opengl", Language.ENGLISH)));
                    log.get().show(CALLS, Setting.values()[0]);
                    scroll.set(new JScrollPane(log.get()));
                });
    }

    private int heightOfTheLongCall(int width) throws Exception {
        var place = new AtomicReference<Rectangle>();
        EventQueue.invokeAndWait(
                () -> {
                    scroll.get().setSize(width, 400);
                    for (int layout = 0; layout < 2; layout++) {
                        scroll.get().doLayout();
                        scroll.get().getViewport().doLayout();
                    }
                    place.set(log.get().getCellBounds(1, 1));
                });
        assertTrue(place.get().width <= width, "the calls are wider than their place");
        return place.get().height;
    }

    @Test
    void longCallGetsTheLinesThatTheWidthAsksFor() throws Exception {
        int narrow = heightOfTheLongCall(240);
        int wide = heightOfTheLongCall(900);
        assertTrue(wide < narrow, wide + " and " + narrow);
        assertEquals(narrow, heightOfTheLongCall(240), "heights of another width stay");
    }

    @Test
    void copiedCallsAreUnbrokenLinesOfAProgram() throws Exception {
        heightOfTheLongCall(240);
        var clipboard = new Clipboard("test");
        EventQueue.invokeAndWait(
                () -> {
                    log.get().setSelectionInterval(0, 1);
                    log.get()
                            .getTransferHandler()
                            .exportToClipboard(log.get(), clipboard, TransferHandler.COPY);
                });
        assertEquals(
                "glEnable(GL_LIGHTING);\n" + LONG + ";\n",
                clipboard.getData(DataFlavor.stringFlavor));
    }
}
