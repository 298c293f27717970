package rasterlab.app.visibility;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Function;
import rasterlab.app.canvas.file.SceneWriting;
import rasterlab.app.language.Texts;
import rasterlab.app.visibility.scene.SavedScene;
import rasterlab.app.visibility.scene.SceneFiles;
import rasterlab.app.visibility.scene.VisibilityChoice;

/** Saves the scene as it is shown when that is asked for, for its own sake or for a command. */
final class SceneSaving {
    private final VisibilityLabModel model;
    private final Texts texts;
    private final SceneWriter writing;

    /** Asks for a file and writes it, as {@link SceneWriting#ask}. */
    @FunctionalInterface
    interface SceneWriter {
        void ask(
                String title,
                String stem,
                Function<Path, Callable<SavedScene>> write,
                Consumer<SavedScene> written);
    }

    SceneSaving(VisibilityLabModel model, Texts texts, SceneWriter writing) {
        this.model = model;
        this.texts = texts;
        this.writing = writing;
    }

    void ask() {
        ask("save.title", saved -> {});
    }

    /** Where no file holds the scene, asks for one first and saves the scene there. */
    void tellCommand(Consumer<String> told) {
        VisibilityCommand command = VisibilityCommand.now(model);
        if (VisibilityCommand.needsFile(model))
            ask("copy.title", saved -> told.accept(command.drawnFrom(saved.file()).text()));
        else told.accept(command.text());
    }

    /**
     * @param title key of what the dialog says above all
     */
    private void ask(String title, Consumer<SavedScene> then) {
        VisibilityChoice choice = model.state().choice();
        writing.ask(
                texts.text(title),
                VisibilityCommand.stem(choice.scene()),
                file -> () -> SceneFiles.save(file, choice),
                saved -> {
                    model.keep(saved);
                    then.accept(saved);
                });
    }
}
