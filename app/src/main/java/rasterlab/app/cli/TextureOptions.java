package rasterlab.app.cli;

import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Option;
import rasterlab.app.model.TextureChange;
import rasterlab.app.outcome.PictureFile;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;

/** The options of {@code ./lab render} that say what lies on the faces. */
final class TextureOptions {
    @Option(
            names = "--texture-image",
            paramLabel = "FILE",
            description = "PNG or JPEG to lay on all faces, 1x1 to 8192x8192 pixels")
    private Path image;

    @Option(
            names = "--wrap",
            paramLabel = "HOW",
            description =
                    "what a texture is beyond its rim: ${COMPLETION-CANDIDATES};"
                            + " default: the scene's, repeat with --texture-image",
            completionCandidates = EngineNames.OfWraps.class)
    private String wrap;

    @Option(
            names = "--environment",
            paramLabel = "MODE",
            description =
                    "how texture and light become one: ${COMPLETION-CANDIDATES};"
                            + " default: the scene's, modulate with --texture-image",
            completionCandidates = EngineNames.OfEnvironments.class)
    private String environment;

    boolean given() {
        return image != null || wrap != null || environment != null;
    }

    /**
     * The scene with its textures as told.
     *
     * @param mode how they are looked up
     * @throws IllegalArgumentException if it has none, or no place for one, or none is shown
     */
    Scene laid(Scene scene, TextureMode mode) {
        if (mode == TextureMode.NONE && given())
            throw new IllegalArgumentException(
                    "--texture-image, --wrap and --environment need a texture to be seen; --texture"
                            + " none shows none");
        Scene changed =
                image == null ? scene : TextureChange.covered(scene, PictureFile.texture(image));
        if (wrap == null && environment == null) return changed;
        if (changed.finishes().stream().allMatch(finish -> finish.texture().isEmpty()))
            throw new IllegalArgumentException(
                    "--wrap and --environment need a texture; scene '%s' has none, --texture-image"
                                    .formatted(scene.name())
                            + " lays one");
        return new TextureChange(
                        Optional.ofNullable(wrap)
                                .map(name -> EngineNames.constant("wrap", Wrap.values(), name)),
                        Optional.ofNullable(environment)
                                .map(
                                        name ->
                                                EngineNames.constant(
                                                        "texture environment",
                                                        Mode.values(),
                                                        name)))
                .of(changed);
    }
}
