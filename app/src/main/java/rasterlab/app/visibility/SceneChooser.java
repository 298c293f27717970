package rasterlab.app.visibility;

import java.awt.Component;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.filechooser.FileFilter;
import rasterlab.app.language.Texts;
import rasterlab.app.model.SceneText;

/** Asks for the file of a scene; one that is there already is written over only if that is said. */
final class SceneChooser extends JFileChooser {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private final transient Predicate<Path> mayReplace;

    SceneChooser(Texts texts) {
        this.texts = texts;
        mayReplace = this::asked;
    }

    /**
     * @param mayReplace asked before a file that is there is written over
     */
    SceneChooser(Texts texts, Predicate<Path> mayReplace) {
        this.texts = texts;
        this.mayReplace = mayReplace;
    }

    /** The file to open; empty if none was chosen. */
    Optional<Path> toOpen(Component parent) {
        setName("open.dialog");
        setFileFilter(opened(texts));
        addChoosableFileFilter(scenes(texts));
        return showOpenDialog(parent) == APPROVE_OPTION
                ? Optional.of(getSelectedFile().toPath())
                : Optional.empty();
    }

    /**
     * The file to write; empty if none was chosen.
     *
     * @param suggested its name
     */
    Optional<Path> toSave(Component parent, String suggested) {
        setName("save.dialog");
        setFileFilter(scenes(texts));
        setSelectedFile(new File(getCurrentDirectory(), suggested));
        return showSaveDialog(parent) == APPROVE_OPTION ? Optional.of(saved()) : Optional.empty();
    }

    /** All that the lab can open. */
    static FileFilter opened(Texts texts) {
        return new Ending(texts.text("files.opened"), SceneFiles.ENDINGS);
    }

    static FileFilter scenes(Texts texts) {
        return new Ending(texts.text("files.scenes"), List.of(SceneText.EXTENSION));
    }

    /** The chosen file with the ending of scene files, whether that was written or not. */
    private Path saved() {
        String path = getSelectedFile().getPath();
        return Path.of(path.endsWith(SceneText.EXTENSION) ? path : path + SceneText.EXTENSION);
    }

    @Override
    public void approveSelection() {
        boolean saving = getDialogType() == SAVE_DIALOG;
        if (saving && Files.exists(saved()) && !mayReplace.test(saved())) return;
        super.approveSelection();
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

    /** Folders, and files whose names end so in any case. */
    private static final class Ending extends FileFilter {
        private final String description;
        private final List<String> endings;

        Ending(String description, List<String> endings) {
            this.description = description;
            this.endings = endings;
        }

        @Override
        public boolean accept(File file) {
            String name = file.getName().toLowerCase(Locale.ROOT);
            return file.isDirectory() || endings.stream().anyMatch(name::endsWith);
        }

        @Override
        public String getDescription() {
            return description;
        }
    }
}
