package rasterlab.app.visibility.scene;

import java.nio.file.Path;
import java.util.Optional;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.transform.SphericalView;

/**
 * The user's files that are shown, as they are kept between runs: by their places, for they may
 * have changed by then.
 *
 * @param view empty where no name of the lab's scenes lacks anything
 * @param up the axis of a model that points up
 */
public record OpenedFiles(Optional<View> view, UpAxis up) {
    public static final OpenedFiles NONE = new OpenedFiles(Optional.empty(), UpAxis.Y);

    /**
     * How a scene was seen, where a scene of the lab in its place is seen otherwise.
     *
     * @param scene the file of a scene or model; empty for a scene of the lab
     * @param picture laid on its faces
     */
    public record View(
            Optional<Path> scene,
            Optional<Path> picture,
            SphericalView camera,
            double zoom,
            LookChoice look) {
        public View {
            if (scene.isEmpty() && picture.isEmpty())
                throw new IllegalArgumentException("neither a scene's file nor a picture's");
        }
    }

    public static OpenedFiles of(VisibilityChoice choice) {
        SceneChoice shown = choice.shown();
        boolean covered = shown.image().isPresent() && Scenes.names().contains(shown.name());
        if (shown.file().isEmpty() && !covered) return NONE;
        return new OpenedFiles(
                Optional.of(
                        new View(
                                shown.file().map(Path::toAbsolutePath),
                                shown.image().map(Path::toAbsolutePath),
                                choice.camera(),
                                choice.zoom(),
                                choice.look())),
                shown.up().orElse(UpAxis.Y));
    }
}
