package rasterlab.exercises.scene;

/**
 * A scene as it is looked at.
 *
 * @param settings what is said about that
 */
public record SceneView(SceneSource source, Settings settings) implements SceneFile {
    /** This view as text; {@link SceneFile#read} gives back what is equal. */
    public String write() {
        return ViewJson.write(this);
    }
}
