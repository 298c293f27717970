package rasterlab.app.exercise.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.TransferHandler.TransferSupport;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rtextarea.RTextScrollPane;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.file.DroppedFiles;
import rasterlab.app.canvas.file.FileDrop;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class SourceDropTest {
    private static final File FILE = new File("a.scene.json");

    private final List<Path> taken = new ArrayList<>();
    private final StringBuilder typed = new StringBuilder();

    /** The editor's text area, asked for on the event thread. */
    private RSyntaxTextArea area(JPanel around) {
        var editor = new SourceEditor(typed::append);
        around.add(editor);
        editor.wear(Texts.of("exercise", Language.ENGLISH));
        var scroll = (RTextScrollPane) editor.getComponent(0);
        return (RSyntaxTextArea) scroll.getTextArea();
    }

    private static boolean put(Transferable content, RSyntaxTextArea area) {
        var support = new TransferSupport(area, content);
        return area.getTransferHandler().canImport(support)
                && area.getTransferHandler().importData(support);
    }

    @Test
    @DisplayName("a file dropped on the editor is refused without a word")
    void fileGoesToWhatIsAround() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var around = new JPanel();
                    around.setTransferHandler(new FileDrop(around, Language.ENGLISH, taken::add));
                    assertTrue(put(DroppedFiles.of(FILE), area(around)));
                });
        EventQueue.invokeAndWait(() -> {});
        assertEquals(List.of(FILE.toPath()), taken);
        assertEquals("", typed.toString());
    }

    @Test
    @DisplayName("where nothing takes files the editor does, or text is not taken any more")
    void textIsTaken() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    RSyntaxTextArea area = area(new JPanel());
                    assertFalse(put(DroppedFiles.of(FILE), area));
                    assertTrue(put(new StringSelection("int x;"), area));
                });
        assertEquals("int x;", typed.toString());
    }
}
