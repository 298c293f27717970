package rasterlab.app.visibility.scene;

import java.nio.file.Path;

/** A scene that the lab wrote into a file, from which a command can draw it. */
public record SavedScene(Path file, SceneChoice scene) {
    /** Whether the file holds what is shown now, however it is looked at. */
    public boolean holds(SceneChoice shown) {
        return scene.equals(shown);
    }
}
