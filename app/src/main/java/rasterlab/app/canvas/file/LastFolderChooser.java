package rasterlab.app.canvas.file;

import java.awt.Component;
import java.io.File;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.Complaint;

/**
 * Asks for a file, first in the folder where one was chosen last; stays open with a name that the
 * system has for no file.
 */
public class LastFolderChooser extends JFileChooser {
    private static final long serialVersionUID = 1L;

    private final Language language;

    public LastFolderChooser(Language language) {
        super(LastChosen.now().standing().orElse(null));
        this.language = language;
    }

    /** The dialog opens in the middle of the whole window, whatever part of it asks. */
    @Override
    protected JDialog createDialog(Component parent) {
        return super.createDialog(JOptionPane.getFrameForComponent(parent));
    }

    /** The file to open; empty if none was chosen. */
    public Optional<Path> toOpen(Component parent) {
        return showOpenDialog(parent) == APPROVE_OPTION ? Optional.of(chosen()) : Optional.empty();
    }

    /**
     * The chosen folder or file.
     *
     * @throws Complaint if the system has no file of such a name
     */
    public final Path chosen() {
        return path(getSelectedFile());
    }

    /**
     * The path of a file.
     *
     * @throws Complaint if the system has no file of such a name
     */
    static Path path(File file) {
        try {
            return file.toPath();
        } catch (InvalidPathException e) {
            String shown = file.getPath().replaceAll("\\p{Cntrl}", "\uFFFD");
            throw Complaint.badInput(shown + ": the system allows no such file name");
        }
    }

    /** Tells why a file cannot be chosen. */
    protected void refuse(String complaint) {
        JOptionPane.showMessageDialog(
                this,
                Complaints.translated(language, complaint),
                getUI().getDialogTitle(this),
                JOptionPane.WARNING_MESSAGE);
    }

    private boolean nameable() {
        try {
            chosen();
            return true;
        } catch (Complaint complaint) {
            refuse(complaint.getMessage());
            return false;
        }
    }

    @Override
    public void approveSelection() {
        if (!nameable()) return;
        Optional.ofNullable(chosen().toAbsolutePath().getParent())
                .ifPresent(folder -> LastChosen.now().in(folder).remember());
        super.approveSelection();
    }
}
