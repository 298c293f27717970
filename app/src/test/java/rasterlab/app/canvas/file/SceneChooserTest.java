package rasterlab.app.canvas.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileFilter;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.shell.UsualLook;

class SceneChooserTest {
    @TempDir Path folder;
    private final List<Path> asked = new ArrayList<>();
    private final List<String> commands = new ArrayList<>();
    private boolean replace;
    private SceneChooser chooser;

    @BeforeEach
    void open() {
        chooser =
                new SceneChooser(
                        Language.ENGLISH,
                        file -> {
                            asked.add(file);
                            return replace;
                        });
        chooser.setDialogType(JFileChooser.SAVE_DIALOG);
        chooser.addActionListener(e -> commands.add(e.getActionCommand()));
    }

    @AfterEach
    void forgetWhatWasChosen() throws Exception {
        EventQueue.invokeAndWait(UsualLook::install);
    }

    private Path choose(String name) {
        chooser.setSelectedFile(new File(folder.toFile(), name));
        chooser.approveSelection();
        return folder.resolve(name);
    }

    @Test
    void fileThatIsKeptLeavesTheDialogOpen() throws Exception {
        Files.writeString(folder.resolve("mine.scene.json"), "mine");
        Path file = choose("mine.scene.json");
        assertEquals(List.of(file), asked);
        assertEquals(List.of(), commands);
        replace = true;
        chooser.approveSelection();
        assertEquals(List.of(JFileChooser.APPROVE_SELECTION), commands);
    }

    @Test
    void fileWithoutItsEndingIsTheOneThatWillBeWritten() throws Exception {
        Files.writeString(folder.resolve("mine.scene.json"), "mine");
        choose("mine");
        assertEquals(List.of(folder.resolve("mine.scene.json")), asked);
        assertEquals(List.of(), commands);
    }

    @Test
    void newFileIsNotAskedAbout() {
        choose("new.scene.json");
        assertEquals(List.of(), asked);
        assertEquals(List.of(JFileChooser.APPROVE_SELECTION), commands);
    }

    @Test
    void fileToOpenIsNotAskedAbout() throws Exception {
        chooser.setDialogType(JFileChooser.OPEN_DIALOG);
        Files.writeString(folder.resolve("mine.scene.json"), "mine");
        choose("mine.scene.json");
        assertEquals(List.of(), asked);
        assertEquals(List.of(JFileChooser.APPROVE_SELECTION), commands);
    }

    @Test
    void filtersLeaveOutWhatCannotBeOpened() {
        FileFilter scenes = SceneChooser.scenes(Language.ENGLISH);
        assertTrue(scenes.accept(new File("Vase.SCENE.json")));
        assertFalse(scenes.accept(new File("report.json")));
        assertFalse(scenes.accept(new File("cube.obj")));
        assertTrue(scenes.accept(folder.toFile()), "folders can be entered");
        FileFilter opened =
                new SceneChooser.EndingFilter(
                        "all", List.of(".scene.json", ".obj", ".png", ".jpeg"));
        for (String name : List.of("vase.scene.json", "cube.obj", "bricks.png", "wood.JPEG"))
            assertTrue(opened.accept(new File(name)), name);
        assertFalse(opened.accept(new File("notes.txt")));
    }
}
