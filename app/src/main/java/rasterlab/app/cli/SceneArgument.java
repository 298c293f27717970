package rasterlab.app.cli;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import rasterlab.app.model.ModelFile;
import rasterlab.app.model.SceneText;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.exercises.scene.SceneView;

/** What {@code ./lab render} shows: a scene by name, or a file. */
final class SceneArgument {
    @Parameters(
            index = "0",
            paramLabel = "SCENE",
            description = {
                "${COMPLETION-CANDIDATES};",
                "or a Wavefront model, FILE.obj, fitted into the picture, with the materials and"
                        + " textures that lie in its folder;",
                "or a scene file, FILE.scene.json"
            },
            completionCandidates = EngineNames.OfScenes.class)
    private String scene;

    @Option(
            names = "--detail",
            paramLabel = "N",
            description =
                    "faces once round a curved surface, 3 to 1024, and half as many across it;"
                            + " default: the scene's")
    private Integer detail;

    @Option(
            names = "--up",
            paramLabel = "AXIS",
            description = "of a model, FILE.obj: the axis that points up, z or y; default: z",
            completionCandidates = EngineNames.OfUpAxes.class)
    private String up;

    /** Of the command that this is an argument of. */
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    /**
     * @param console where what a file leaves out is told
     * @throws IllegalArgumentException for an unknown name or a detail the scene has not
     */
    ShownScene open(Console console) {
        String name = scene.toLowerCase(Locale.ROOT);
        boolean model = name.endsWith(".obj");
        boolean view = name.endsWith(SceneText.EXTENSION);
        if (detail != null && (model || view))
            throw new IllegalArgumentException("--detail is for scenes by name, not for a file");
        if (up != null && !model)
            throw new IllegalArgumentException("--up is for a model, FILE.obj; scenes have z up");
        if (view) return shown(SceneText.view(Path.of(scene)));
        if (model)
            return plain(
                    ModelFile.read(
                            Path.of(scene),
                            up == null ? UpAxis.Z : UpAxis.named(up),
                            note -> console.err().println("note: " + note)));
        return plain(detail == null ? Scenes.named(scene) : Scenes.named(scene, detail));
    }

    private ShownScene plain(Scene opened) {
        return new ShownScene(opened, Map.of(), option -> true);
    }

    private ShownScene shown(SceneView view) {
        Map<String, String> said = new HashMap<>();
        view.projection().ifPresent(value -> said.put("--projection", value));
        view.visibility().ifPresent(value -> said.put("--visibility", value));
        view.shading().ifPresent(value -> said.put("--shading", value));
        view.texture().ifPresent(value -> said.put("--texture", value));
        Scene held = view.source().scene();
        return new ShownScene(
                view.camera().map(held::seenFrom).orElse(held),
                said,
                command.commandLine().getParseResult()::hasMatchedOption);
    }
}
