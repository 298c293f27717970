package rasterlab.app.cli.render;

import java.nio.file.Path;
import picocli.CommandLine.Option;
import rasterlab.app.model.TextureChange;
import rasterlab.app.outcome.PictureFile;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;
import rasterlab.exercises.scene.SceneSetting;

/** The options of {@code ./lab render} that say what lies on the faces. */
final class TextureOptions {
    @Option(
            names = "--texture-image",
            paramLabel = "FILE",
            description = "PNG, JPEG, GIF or BMP to lay on all faces, 1x1 to 8192x8192 pixels")
    private Path image;

    @Option(
            names = "--wrap",
            paramLabel = "HOW",
            description =
                    "what is drawn beyond the texture's edge: ${COMPLETION-CANDIDATES};"
                            + " default: the scene's, repeat with --texture-image",
            completionCandidates = EngineNames.OfWraps.class)
    private String wrap;

    @Option(
            names = "--environment",
            paramLabel = "MODE",
            description =
                    "how the texture is combined with the light: ${COMPLETION-CANDIDATES};"
                            + " default: the scene's, modulate with --texture-image",
            completionCandidates = EngineNames.OfEnvironments.class)
    private String environment;

    boolean given() {
        return image != null || wrap != null || environment != null;
    }

    /**
     * The scene with its textures as told; what its file tells is passed over where it has none.
     *
     * @param shown the scene's file
     * @param mode how they are looked up
     * @throws IllegalArgumentException if it has none, or no place for one, or none is shown
     */
    Scene laid(ShownScene shown, Scene scene, TextureMode mode) {
        if (mode == TextureMode.NONE && given())
            throw new IllegalArgumentException(
                    "--texture-image, --wrap and --environment need a texture to be seen; --texture"
                            + " none shows none");
        Scene changed = covered(shown, scene, mode);
        if (changed.finishes().stream().allMatch(finish -> finish.texture().isEmpty())) {
            requireNothing(shown, scene, mode);
            return changed;
        }
        Wrap along = wrap == null ? null : EngineNames.constant("wrap", Wrap.values(), wrap);
        Mode mixed =
                environment == null
                        ? null
                        : EngineNames.constant("texture environment", Mode.values(), environment);
        return new TextureChange(
                        shown.option(along, SceneSetting.WRAP),
                        shown.option(mixed, SceneSetting.ENVIRONMENT))
                .of(changed);
    }

    /** The file's picture is not looked for where the command line has another or shows none. */
    private Scene covered(ShownScene shown, Scene scene, TextureMode mode) {
        if (image != null) return TextureChange.covered(scene, PictureFile.texture(image));
        if (mode == TextureMode.NONE) return scene;
        return shown.covered(scene).orElse(scene);
    }

    /** Passes unless the command line asks for something of a texture that is not there. */
    private void requireNothing(ShownScene shown, Scene scene, TextureMode mode) {
        boolean looked =
                mode != TextureMode.AUTO
                        && mode != TextureMode.NONE
                        && shown.onCommandLine().test("--texture");
        String asked =
                looked ? "--texture " + mode.code() + " needs" : "--wrap and --environment need";
        if (looked || wrap != null || environment != null)
            throw new IllegalArgumentException(
                    "%s a texture; scene '%s' has none, --texture-image lays one"
                            .formatted(asked, scene.name()));
    }
}
