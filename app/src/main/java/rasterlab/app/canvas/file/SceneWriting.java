package rasterlab.app.canvas.file;

import java.awt.Component;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Function;
import rasterlab.app.language.Language;
import rasterlab.app.model.SceneText;

/** Asks for the file of a scene and writes the scene there, for its own sake or for a command. */
public final class SceneWriting {
    private final Component parent;
    private final Language language;
    private final FileWriting writing;
    private final Consumer<Path> onSaved;

    /**
     * @param parent of the dialogs
     * @param onSaved told on the event thread which file is written
     * @param onFailure told what writing threw that no dialog explains
     */
    public SceneWriting(
            Component parent,
            Language language,
            Consumer<Path> onSaved,
            Consumer<Throwable> onFailure) {
        this.parent = parent;
        this.language = language;
        this.onSaved = onSaved;
        writing = new FileWriting(parent, language, onFailure);
    }

    /**
     * @param title of the dialogs
     * @param stem of the file's suggested name
     * @param write what writes the scene as it is now, on a thread of its own
     * @param written told its answer on the event thread; not at all where no file was chosen
     */
    public <T> void ask(
            String title, String stem, Function<Path, Callable<T>> write, Consumer<T> written) {
        var chooser = new SceneChooser(language);
        chooser.setDialogTitle(title);
        chooser.toSave(parent, stem + SceneText.EXTENSION)
                .ifPresent(
                        file ->
                                writing.write(
                                        title,
                                        write.apply(file),
                                        answer -> {
                                            onSaved.accept(file);
                                            written.accept(answer);
                                        }));
    }
}
