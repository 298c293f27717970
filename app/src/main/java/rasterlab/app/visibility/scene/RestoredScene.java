package rasterlab.app.visibility.scene;

import java.nio.file.Path;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.PictureFile;
import rasterlab.engine.scene.obj.UpAxis;

/**
 * A scene of the user's files on its way back after a restart.
 *
 * @param view as it was left, which need not be as a scene file says
 * @param up the axis of a model that points up
 * @param before what was shown in its place when its reading began
 */
public record RestoredScene(OpenedFiles.View view, UpAxis up, VisibilityChoice before) {
    /** A file of it to name. */
    Path file() {
        return view.scene().or(view::picture).orElseThrow();
    }

    /** The message where nothing comes back. */
    String instead() {
        return "; the scene " + before.scene() + " is shown instead";
    }

    /**
     * Reads the scene, without its picture where that cannot be laid on it.
     *
     * @throws Complaint naming the file and the place in it, if the scene cannot be read
     */
    SceneFiles.SceneAnswer read() {
        SceneChoice bare =
                view.scene().map(file -> SceneFiles.scene(file, up)).orElse(before.shown());
        if (view.picture().isEmpty()) return shown(bare, "");
        Path picture = view.picture().get();
        try {
            return shown(bare.covered(picture, PictureFile.texture(picture)), "");
        } catch (Complaint complaint) {
            return uncovered(bare, complaint.getMessage());
        } catch (IllegalArgumentException e) {
            return uncovered(bare, picture + ": " + e.getMessage());
        }
    }

    private SceneFiles.SceneAnswer uncovered(SceneChoice bare, String problem) {
        return shown(
                bare, problem + "; the scene " + bare.name() + " is shown without the picture");
    }

    private SceneFiles.SceneAnswer shown(SceneChoice scene, String problem) {
        return new SceneFiles.SceneAnswer(
                now -> {
                    try {
                        return seen(now, scene);
                    } catch (IllegalArgumentException e) {
                        throw new IllegalArgumentException(
                                file() + ": " + e.getMessage() + instead(), e);
                    }
                },
                problem);
    }

    /** Opens the file that was read; a choice that the user made since stays. */
    private VisibilityChoice seen(VisibilityChoice now, SceneChoice scene) {
        VisibilityChoice chosen = now.alike(scene);
        VisibilityChoice next =
                chosen.withCamera(
                                now.camera().equals(before.camera())
                                        ? view.camera()
                                        : chosen.camera())
                        .withZoom(now.zoom() == before.zoom() ? view.zoom() : chosen.zoom())
                        .with(now.look().equals(before.look()) ? view.look() : chosen.look());
        next.plain(2, 1); // Refuses what cannot be drawn so.
        return next;
    }
}
