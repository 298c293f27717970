package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Window;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.TransferHandler.TransferSupport;
import javax.swing.text.JTextComponent;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** Where dialogs open, and what is said beside the buttons, under a real display. */
class WindowDialogsTest extends WindowHarness {
    /**
     * One pixel may go to either side. Where no window manager places dialogs, AWT now and then
     * takes one to be in the screen's corner, wherever it is.
     */
    private void assertInTheMiddle(Component part) {
        Window dialog = SwingUtilities.getWindowAncestor(part);
        if (dialog.getLocation().equals(new Point())) return;
        Point is = middle(dialog);
        Point wanted = middle(frame);
        assertTrue(is.distance(wanted) < 2, dialog.getName() + " at " + is + ", not " + wanted);
    }

    private static Point middle(Window window) {
        return new Point(
                window.getX() + window.getWidth() / 2, window.getY() + window.getHeight() / 2);
    }

    private void press(String button) {
        var pressed = (AbstractButton) robot.finder().findByName(frame, button);
        GuiActionRunner.execute(() -> EventQueue.invokeLater(pressed::doClick));
    }

    @Test
    @DisplayName("the dialog for a picture's file opens over its button")
    void chooserOpensInTheMiddleOfTheWindow() {
        press("savePicture");
        var dialog = window.fileChooser("save.dialog");
        assertInTheMiddle(dialog.target());
        dialog.cancel();
    }

    @Test
    @DisplayName("the dialog for a server opens over its button")
    void formOpensInTheMiddleOfTheWindow() {
        show("exercises");
        press("server");
        var dialog = window.optionPane();
        assertInTheMiddle(dialog.target());
        dialog.pressAndReleaseKeys(KeyEvent.VK_ESCAPE);
    }

    @Test
    @DisplayName("a file dropped on a tab that opens none is passed over in silence")
    void strayFileIsToldItsTabs() {
        var content = (JComponent) frame.getContentPane().getComponent(0);
        GuiActionRunner.execute(() -> content.getTransferHandler().importData(holding("a.obj")));
        var dialog = window.optionPane();
        String said = dialog.target().getMessage().toString();
        assertTrue(said.contains("“a.obj”") && said.contains("“Hidden surfaces”"), said);
        assertInTheMiddle(dialog.target());
        dialog.pressAndReleaseKeys(KeyEvent.VK_ENTER);
    }

    @Test
    @DisplayName("a file dropped on a text or a list is refused in silence")
    void filesAreTakenWhereverTextOrAListIsSeen() {
        for (String tab : List.of("coordinates", "light", "opengl", "study", "exercises")) {
            show(tab);
            for (Component part : robot.finder().findAll(frame, WindowDialogsTest::isRead))
                assertTrue(takesFiles(part), tab + ": " + part.getName());
        }
    }

    private static boolean isRead(Component part) {
        boolean read = part instanceof JTextComponent text && !text.isEditable();
        return (read || part instanceof JList || "source".equals(part.getName()))
                && part.isShowing();
    }

    /** Whether the nearest drop target does that is at work. */
    private static boolean takesFiles(Component part) {
        for (Component each = part; each instanceof JComponent shown; each = each.getParent())
            if (each.getDropTarget() != null && each.getDropTarget().isActive())
                return shown.getTransferHandler().canImport(holding(shown, "a.obj"));
        return false;
    }

    private static TransferSupport holding(String file) {
        return holding(new JPanel(), file);
    }

    private static TransferSupport holding(Component target, String file) {
        var files =
                new Transferable() {
                    @Override
                    public DataFlavor[] getTransferDataFlavors() {
                        return new DataFlavor[] {DataFlavor.javaFileListFlavor};
                    }

                    @Override
                    public boolean isDataFlavorSupported(DataFlavor flavor) {
                        return flavor.equals(DataFlavor.javaFileListFlavor);
                    }

                    @Override
                    public Object getTransferData(DataFlavor flavor) {
                        return List.of(Path.of(file).toFile());
                    }
                };
        return new TransferSupport(target, files);
    }

    @Test
    @DisplayName("nothing says that something was copied, and what")
    void copyingSaysWhatIsOnTheClipboard() {
        press("copyCommand");
        awaitSaid("On the clipboard: the command that does the same in a terminal");
        press("copyPicture");
        await(
                "the picture",
                () -> status().matches("On the clipboard: the picture, \\d+×\\d+ pixels"));
        press("copySvg");
        awaitSaid("On the clipboard: the drawing (SVG)");
        assertEquals("<?xml", clipboardText().substring(0, 5));
    }

    private static String clipboardText() {
        try {
            return (String)
                    java.awt.Toolkit.getDefaultToolkit()
                            .getSystemClipboard()
                            .getData(DataFlavor.stringFlavor);
        } catch (java.awt.datatransfer.UnsupportedFlavorException | java.io.IOException e) {
            throw new AssertionError("the clipboard has no text", e);
        }
    }

    private void awaitSaid(String sentence) {
        await(sentence, () -> status().equals(sentence));
    }
}
