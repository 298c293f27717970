package rasterlab.app.canvas.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.JFileChooser;
import javax.swing.plaf.basic.BasicFileChooserUI;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.shell.UsualLook;

class PictureChooserTest {
    @TempDir Path folder;
    private final List<Path> asked = new ArrayList<>();
    private final List<String> refused = new ArrayList<>();
    private final List<String> commands = new ArrayList<>();
    private PictureChooser chooser;

    private final class Recording extends PictureChooser {
        private static final long serialVersionUID = 1L;

        Recording(Predicate<Path> mayReplace) {
            super(Language.ENGLISH, mayReplace);
        }

        @Override
        protected void refuse(String complaint) {
            refused.add(complaint);
        }
    }

    @BeforeEach
    void open() {
        LastChosen.NONE.remember();
        chooser = new Recording(asked::add);
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

    private void isRefused(Path file, String reason) {
        assertEquals(List.of(), commands);
        assertEquals(1, refused.size());
        assertEquals(file + ": " + reason, refused.get(0));
    }

    @ParameterizedTest(name = "{0} with the filter {1} becomes {2}")
    @CsvSource({
        "house,     0, house.png",
        "house,     1, house.svg",
        "house.svg, 0, house.svg",
        "house.PNG, 1, house.PNG",
        ".house,    1, .house.svg"
    })
    void typedEndingCountsBeforeTheFilter(String typed, int filter, String written) {
        chooser.setFileFilter(chooser.getChoosableFileFilters()[filter]);
        assertEquals(folder.resolve(written), chooser.named(folder.resolve(typed)));
    }

    @Test
    void otherEndingIsRefusedWithThoseThatAreAllowed() {
        Path file = choose("house.jpg");
        isRefused(file, "unknown extension; allowed are .png and .svg");
    }

    @Test
    void nameThatTheSystemRefusesIsToldWithoutItsControlCharacter() {
        chooser.setSelectedFile(new File(folder.toFile(), "ho\0use.png"));
        chooser.approveSelection();
        isRefused(folder.resolve("ho\uFFFDuse.png"), "the system allows no such file name");
    }

    @Test
    void typedFolderThatIsNotThereStays() {
        Path file = choose("none/house.png");
        assertEquals(1, refused.size());
        assertEquals(file.toString(), ((BasicFileChooserUI) chooser.getUI()).getFileName());
    }

    @Test
    void folderUnderThatNameIsRefused() throws Exception {
        Path file = Files.createDirectory(folder.resolve("house.png"));
        choose("house");
        isRefused(file, "cannot be written: it is a folder");
    }

    @Test
    void folderThatIsNotThereIsRefused() {
        Path file = choose("none/house.png");
        isRefused(file, "cannot be written: no folder " + folder.resolve("none"));
    }

    /** The folder takes no files, whoever asks. */
    @Test
    void folderThatTakesNoFilesIsRefused() {
        Path folder = Path.of("/proc/self");
        org.junit.jupiter.api.Assumptions.assumeTrue(Files.isDirectory(folder), "no such folder");
        chooser.setSelectedFile(folder.resolve("house.png").toFile());
        chooser.approveSelection();
        assertEquals(List.of(), commands);
        assertTrue(refused.get(0).contains("a file cannot be made in " + folder), refused.get(0));
    }

    @Test
    void fileThatIsThereIsAskedForUnderTheNameThatIsWritten() throws Exception {
        Path file = Files.writeString(folder.resolve("house.png"), "mine");
        choose("house");
        assertEquals(List.of(file), asked);
        assertEquals(List.of(JFileChooser.APPROVE_SELECTION), commands);
    }

    @ParameterizedTest(name = "the next dialog forgets the form of {0}, saved with the filter {1}")
    @CsvSource({"house, 1, svg", "tree, 0, png", "house.svg, 0, svg", "tree.png, 1, png"})
    void nextDialogOffersTheFormThatWasChosenLast(String name, int filter, String ending) {
        chooser.setFileFilter(chooser.getChoosableFileFilters()[filter]);
        choose(name);
        var next = new PictureChooser(Language.ENGLISH);
        assertEquals(folder.resolve("next." + ending), next.named(folder.resolve("next")));
    }

    @Test
    void aFolderThatHasGoneIsForgotten() {
        File usual = new LastFolderChooser(Language.ENGLISH).getCurrentDirectory();
        new LastChosen(Optional.of(folder.resolve("gone")), PictureForm.SVG).remember();
        var next = new PictureChooser(Language.ENGLISH);
        assertEquals(usual, next.getCurrentDirectory());
        assertEquals(folder.resolve("next.svg"), next.named(folder.resolve("next")));
    }

    @Test
    void nextDialogOpensInTheFolderOfTheLast() {
        choose("house");
        assertEquals(
                folder.toFile(), new LastFolderChooser(Language.ENGLISH).getCurrentDirectory());
    }
}
