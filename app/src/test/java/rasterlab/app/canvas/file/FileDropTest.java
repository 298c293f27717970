package rasterlab.app.canvas.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JPanel;
import javax.swing.TransferHandler.TransferSupport;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;

class FileDropTest {
    private final List<Path> taken = new ArrayList<>();
    private final List<String> told = new ArrayList<>();
    private final FileDrop drop = new FileDrop(Language.ENGLISH, taken::add, told::add);

    @Test
    @DisplayName("a dropped file is not taken, or while the drop still goes on")
    void takesTheFileAfterTheDrop() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    assertTrue(dropped(new File("a.scene.json")));
                    assertEquals(List.of(), taken);
                });
        EventQueue.invokeAndWait(() -> {});
        assertEquals(List.of(Path.of("a.scene.json")), taken);
        assertEquals(List.of(), told);
    }

    @Test
    @DisplayName("of two files one is taken without a word")
    void takesNoneOfSeveralAndTellsHowMany() throws Exception {
        EventQueue.invokeAndWait(() -> assertFalse(dropped(new File("a.obj"), new File("b.obj"))));
        EventQueue.invokeAndWait(() -> {});
        assertEquals(List.of(), taken);
        assertEquals(
                List.of("2 files were dropped: one is opened at a time. Nothing was changed."),
                told);
    }

    @Test
    @DisplayName("a name that the system refuses is thrown out of the drop")
    void tellsANameThatCannotBeUsed() throws Exception {
        EventQueue.invokeAndWait(() -> assertFalse(dropped(new File("a\0b.png"))));
        EventQueue.invokeAndWait(() -> {});
        assertEquals(List.of(), taken);
        assertEquals(List.of("a\uFFFDb.png: the system allows no such file name"), told);
    }

    @Test
    @DisplayName("files that are gone are thrown out of the drop")
    void tellsFilesThatCannotBeHad() throws Exception {
        Transferable gone = new DroppedFiles(List.of(), Optional.of(new IOException("it is gone")));
        EventQueue.invokeAndWait(() -> assertFalse(drop.importData(onto(gone))));
        EventQueue.invokeAndWait(() -> {});
        assertEquals(List.of("The dropped file could not be had: it is gone."), told);
    }

    @Test
    @DisplayName("text is taken for a file")
    void takesNoText() {
        assertFalse(drop.canImport(onto(new StringSelection("/tmp/a.obj"))));
        assertFalse(drop.importData(onto(new StringSelection("/tmp/a.obj"))));
        assertEquals(List.of(), told);
    }

    @Test
    @DisplayName("files that are pasted with their names are opened where names are typed")
    void takesAPasteWithoutTextAlone() {
        var around = new JPanel();
        around.setTransferHandler(drop);
        var inner = new JPanel();
        around.add(inner);
        var files = DroppedFiles.of(new File("a.obj"));
        assertEquals(Optional.of(drop), FileDrop.around(new TransferSupport(inner, files)));
        assertEquals(Optional.empty(), FileDrop.around(new TransferSupport(inner, named(files))));
    }

    /** Files as file managers copy them: with their names as text. */
    private static Transferable named(Transferable files) {
        return new StringSelection("a.obj") {
            @Override
            public boolean isDataFlavorSupported(DataFlavor flavor) {
                return super.isDataFlavorSupported(flavor) || files.isDataFlavorSupported(flavor);
            }

            @Override
            public DataFlavor[] getTransferDataFlavors() {
                return new DataFlavor[] {DataFlavor.javaFileListFlavor, DataFlavor.stringFlavor};
            }
        };
    }

    private boolean dropped(File... files) {
        return drop.importData(onto(DroppedFiles.of(files)));
    }

    private static TransferSupport onto(Transferable files) {
        return new TransferSupport(new JPanel(), files);
    }
}
