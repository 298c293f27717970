package rasterlab.exercises.scene;

/**
 * A scene as it is looked at.
 *
 * @param settings what is said about that
 */
public record SceneView(SceneSource source, Settings settings) implements SceneFile {
    @Override
    public String write() {
        return ViewJson.write(this);
    }
}
