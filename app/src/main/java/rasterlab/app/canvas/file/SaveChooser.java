package rasterlab.app.canvas.file;

import java.awt.Component;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import javax.swing.JOptionPane;
import javax.swing.plaf.basic.BasicFileChooserUI;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.WholeFile;

/**
 * Asks for a file that can be written; one that is there already is written over only if that is
 * said.
 */
public class SaveChooser extends LastFolderChooser {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private final transient UnaryOperator<Path> named;
    private final transient Predicate<Path> mayReplace;

    /**
     * @param named the file that is written for a chosen one, such as with its ending
     */
    public SaveChooser(Language language, UnaryOperator<Path> named) {
        super(language);
        texts = Texts.of("canvas", language);
        this.named = named;
        mayReplace = this::asked;
    }

    /**
     * @param mayReplace asked before a file that is there is written over
     */
    protected SaveChooser(
            Language language, UnaryOperator<Path> named, Predicate<Path> mayReplace) {
        super(language);
        texts = Texts.of("canvas", language);
        this.named = named;
        this.mayReplace = mayReplace;
    }

    /**
     * The file to write; empty if none was chosen.
     *
     * @param suggested its name
     */
    public Optional<Path> toSave(Component parent, String suggested) {
        setName("save.dialog");
        setSelectedFile(new File(getCurrentDirectory(), suggested));
        return showSaveDialog(parent) == APPROVE_OPTION ? Optional.of(saved()) : Optional.empty();
    }

    private Path saved() {
        return named(chosen());
    }

    /**
     * The file that is written for a chosen one.
     *
     * @throws Complaint if it cannot be written under that name
     */
    protected Path named(Path chosen) {
        return named.apply(chosen);
    }

    /** Stays open with what cannot be written. */
    @Override
    public void approveSelection() {
        if (getDialogType() != SAVE_DIALOG || writable()) super.approveSelection();
        else showWhole(getSelectedFile());
    }

    /** A folder that is not there cannot be entered, so it stays where it was typed. */
    private void showWhole(File file) {
        boolean entered = getCurrentDirectory().equals(file.getAbsoluteFile().getParentFile());
        if (!entered && getUI() instanceof BasicFileChooserUI shown)
            shown.setFileName(file.getPath());
    }

    private boolean writable() {
        try {
            Path file = saved();
            WholeFile.requireWritable(file);
            return !Files.exists(file) || mayReplace.test(file);
        } catch (Complaint complaint) {
            refuse(complaint.getMessage());
            return false;
        }
    }

    /** The answer that keeps the file is the one that Enter, Escape and closing give. */
    private boolean asked(Path file) {
        Object[] answers = {texts.text("replace.yes"), texts.text("replace.no")};
        int answer =
                JOptionPane.showOptionDialog(
                        this,
                        texts.text("replace", file.getFileName()),
                        texts.text("replace.title"),
                        JOptionPane.DEFAULT_OPTION,
                        JOptionPane.WARNING_MESSAGE,
                        null,
                        answers,
                        answers[1]);
        return answer == 0;
    }
}
