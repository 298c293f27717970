package rasterlab.app.cli.render;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import rasterlab.app.cli.console.ComplaintText;
import rasterlab.app.cli.console.Console;
import rasterlab.app.model.ModelFile;
import rasterlab.app.model.SceneText;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.exercises.scene.SceneSetting;
import rasterlab.exercises.scene.SceneSource;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Settings;

/** The scene that {@code ./lab render} draws, given by its name or as a file. */
final class SceneArgument {
    @Parameters(
            index = "0",
            paramLabel = "SCENE",
            description = {
                "${COMPLETION-CANDIDATES};",
                "or a Wavefront model, FILE.obj, fitted into the picture, with the materials and"
                        + " textures that lie in its folder;",
                "or a scene file, FILE.scene.json, which may say how it is drawn: the options given"
                        + " here override it (its format: README, Scene files)"
            },
            completionCandidates = EngineNames.OfScenes.class)
    private String scene;

    @Option(
            names = "--detail",
            paramLabel = "N",
            description =
                    "number of faces around a curved body, 3 to 1024 (half as many along it); built-in"
                            + " scenes only; default: the scene's")
    private Integer detail;

    @Option(
            names = "--up",
            paramLabel = "AXIS",
            description = "for a model, FILE.obj: the axis that points up, y or z; default: y",
            completionCandidates = EngineNames.OfUpAxes.class)
    private String up;

    @Option(
            names = "--scene-only",
            description =
                    "takes the scene of a scene file, not what the file says about drawing it")
    private boolean sceneOnly;

    /** The command that this is an argument of. */
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    /**
     * @param console where what a file leaves out is told
     * @throws IllegalArgumentException for an unknown name or a detail the scene has not
     */
    ShownScene open(Console console) {
        var complaints = new ComplaintText(console.language());
        String name = scene.toLowerCase(Locale.ROOT);
        boolean model = isModel();
        boolean view = name.endsWith(SceneText.EXTENSION);
        if (detail != null && model)
            throw new IllegalArgumentException("--detail is for scenes by name, not for a model");
        if (up != null && !model)
            throw new IllegalArgumentException("--up is for a model, FILE.obj; scenes have z up");
        if (sceneOnly && !view)
            throw new IllegalArgumentException("--scene-only is for a scene file, FILE.scene.json");
        if (view) return shown(Path.of(scene));
        if (model) return model(note -> console.tell("note", complaints.note(note)));
        return plain(detail == null ? Scenes.named(scene) : Scenes.named(scene, detail));
    }

    private ShownScene model(Consumer<String> notes) {
        UpAxis chosen = up == null ? UpAxis.Y : UpAxis.named(up);
        Scene read = ModelFile.read(Path.of(scene), chosen, notes);
        if (up == null)
            notes.accept(scene + ": y is taken to point up; --up z turns a model where z does");
        return plain(read);
    }

    /** Whether a model is shown, which may be anything. */
    boolean isModel() {
        return scene.toLowerCase(Locale.ROOT).endsWith(".obj");
    }

    /** Tells that a model's picture is empty. */
    void tellEmpty(Console console) {
        console.tell(
                "note",
                new ComplaintText(console.language())
                        .note(
                                scene
                                        + ": nothing of the model is seen: no pixel differs from the"
                                        + " background; --camera, --zoom, --near, --far and --cull"
                                        + " change what is seen"));
    }

    private ShownScene plain(Scene opened) {
        return new ShownScene(opened, Settings.NONE, Optional.empty(), option -> true);
    }

    private ShownScene shown(Path file) {
        SceneView view = SceneText.view(file);
        Scene held = held(file, view.source());
        if (sceneOnly) return plain(held);
        Settings said = view.settings();
        return new ShownScene(
                said.get(SceneSetting.CAMERA).map(held::seenFrom).orElse(held),
                said,
                Optional.of(file),
                command.commandLine().getParseResult()::hasMatchedOption);
    }

    private Scene held(Path file, SceneSource source) {
        if (detail == null) return source.scene();
        if (source instanceof SceneSource.ByName named) return Scenes.named(named.name(), detail);
        throw new IllegalArgumentException(
                "--detail is for scenes by name; %s holds the scene itself".formatted(file));
    }
}
