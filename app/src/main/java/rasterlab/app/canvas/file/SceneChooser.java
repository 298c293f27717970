package rasterlab.app.canvas.file;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.filechooser.FileFilter;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.model.SceneText;

/** Asks for the file of a scene; one that is there already is written over only if that is said. */
public final class SceneChooser extends SaveChooser {
    private static final long serialVersionUID = 1L;

    private final transient FileFilter scenes;

    public SceneChooser(Language language) {
        super(language, SceneText::named);
        scenes = scenes(language);
    }

    /**
     * @param mayReplace asked before a file that is there is written over
     */
    SceneChooser(Language language, Predicate<Path> mayReplace) {
        super(language, SceneText::named, mayReplace);
        scenes = scenes(language);
    }

    @Override
    public Optional<Path> toOpen(Component parent) {
        setName("open.dialog");
        setFileFilter(scenes);
        return super.toOpen(parent);
    }

    /**
     * The file to open, first among more than scenes.
     *
     * @param description of the files shown at first
     * @param endings of their names, lower-case
     */
    public Optional<Path> toOpen(Component parent, String description, List<String> endings) {
        setName("open.dialog");
        setFileFilter(new EndingFilter(description, endings));
        addChoosableFileFilter(scenes);
        return super.toOpen(parent);
    }

    @Override
    public Optional<Path> toSave(Component parent, String suggested) {
        setFileFilter(scenes);
        return super.toSave(parent, suggested);
    }

    static FileFilter scenes(Language language) {
        return new EndingFilter(
                Texts.of("canvas", language).text("files.scenes"), List.of(SceneText.EXTENSION));
    }

    /** Folders, and files whose names end so in any case. */
    static final class EndingFilter extends FileFilter {
        private final String description;
        private final List<String> endings;

        EndingFilter(String description, List<String> endings) {
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
