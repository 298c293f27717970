package rasterlab.app.visibility;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.filechooser.FileFilter;
import rasterlab.app.canvas.SaveChooser;
import rasterlab.app.language.Texts;
import rasterlab.app.model.SceneText;

/** Asks for the file of a scene; one that is there already is written over only if that is said. */
final class SceneChooser extends SaveChooser {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;

    SceneChooser(Texts texts) {
        super(texts.language(), SceneText::named);
        this.texts = texts;
    }

    /**
     * @param mayReplace asked before a file that is there is written over
     */
    SceneChooser(Texts texts, Predicate<Path> mayReplace) {
        super(texts.language(), SceneText::named, mayReplace);
        this.texts = texts;
    }

    @Override
    public Optional<Path> toOpen(Component parent) {
        setName("open.dialog");
        setFileFilter(opened(texts));
        addChoosableFileFilter(scenes(texts));
        return super.toOpen(parent);
    }

    @Override
    public Optional<Path> toSave(Component parent, String suggested) {
        setFileFilter(scenes(texts));
        return super.toSave(parent, suggested);
    }

    /** All that the lab can open. */
    static FileFilter opened(Texts texts) {
        return new Ending(texts.text("files.opened"), SceneFiles.ENDINGS);
    }

    static FileFilter scenes(Texts texts) {
        return new Ending(texts.text("files.scenes"), List.of(SceneText.EXTENSION));
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
