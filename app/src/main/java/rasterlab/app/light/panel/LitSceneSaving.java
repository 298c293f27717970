package rasterlab.app.light.panel;

import java.awt.Component;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.SceneChooser;
import rasterlab.app.canvas.file.SceneWriting;
import rasterlab.app.language.Texts;
import rasterlab.app.light.LightChoice;
import rasterlab.app.light.LightFrame;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.light.LitSceneFile;
import rasterlab.app.light.OpenedLitScene;

/** Asks for a file, saves the lit scene there, and knows the commands that draw it from there. */
final class LitSceneSaving {
    private final LightLabModel model;
    private final Texts texts;
    private final Component parent;
    private final SceneWriting writing;

    /**
     * @param parent of the dialogs
     */
    LitSceneSaving(LightLabModel model, Texts texts, Component parent, SceneWriting writing) {
        this.model = model;
        this.texts = texts;
        this.parent = parent;
        this.writing = writing;
    }

    /** The commands for the three pictures; empty where no file holds the scene. */
    Optional<String> commands() {
        LightChoice choice = model.state().choice();
        return model.saved()
                .filter(file -> file.holds(choice))
                .flatMap(
                        file ->
                                model.state()
                                        .drawn()
                                        .map(d -> file.commands(choice, d.width(), d.height())));
    }

    /**
     * Tells the commands for the three pictures; where no file holds the scene, asks for one first
     * and saves the scene there.
     */
    void tellCommands(Consumer<String> told) {
        commands()
                .ifPresentOrElse(
                        told, () -> ask("copy.title", file -> told.accept(commands(file))));
    }

    /** The commands for what the file holds, even if the lamps have gone on since. */
    private String commands(LitSceneFile file) {
        LightFrame.DrawnFrame drawn = model.state().drawn().orElseThrow();
        return file.commands(file.choice(), drawn.width(), drawn.height());
    }

    void ask() {
        ask("scene.save.title", file -> {});
    }

    /**
     * @param title key of what the dialog says above all
     */
    private void ask(String title, Consumer<LitSceneFile> then) {
        LightChoice choice = model.state().choice();
        writing.ask(
                texts.text(title),
                choice.body().stem().replaceFirst("-lit$", "") + "-lit",
                file -> () -> LitSceneFile.write(choice, file),
                written -> {
                    model.keep(written);
                    then.accept(written);
                });
    }

    /** Asks for a file and opens it. */
    void open() {
        var chooser = new SceneChooser(texts.language());
        chooser.setDialogTitle(texts.text("scene.open.title"));
        chooser.toOpen(parent, texts.text("files.opened"), OpenedLitScene.ENDINGS)
                .ifPresent(model::open);
    }
}
