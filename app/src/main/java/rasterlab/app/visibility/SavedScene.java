package rasterlab.app.visibility;

import java.nio.file.Path;

/** A scene that the lab wrote into a file, from which a command can draw it. */
record SavedScene(Path file, SceneChoice scene) {
    /** Whether the file holds what is shown now, however it is looked at. */
    boolean holds(SceneChoice shown) {
        return scene.equals(shown);
    }
}
