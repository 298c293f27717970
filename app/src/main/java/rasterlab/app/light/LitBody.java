package rasterlab.app.light;

import com.fasterxml.jackson.annotation.JsonCreator;
import com.fasterxml.jackson.annotation.JsonIgnore;
import com.fasterxml.jackson.annotation.JsonProperty;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import rasterlab.app.mine.OwnMethods;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SmoothedMesh;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.obj.UpAxis;

/**
 * The body that is lit.
 *
 * @param name of a scene, or {@code TOPIC/HAZARD}
 * @param detail faces once round, for a scene that is made in steps
 * @param normals {@value #OWN}, or a method of topic {@code vertex-normals}, which may be the
 *     user's program
 * @param opened the scene of a file; kept as long as the program runs
 */
public record LitBody(
        String name, int detail, String normals, @JsonIgnore Optional<OpenedScene> opened) {
    /**
     * @param file where it was read from, an absolute path
     * @param up the axis of a model that points up; empty for a scene file
     */
    public record OpenedScene(Path file, Scene scene, Optional<UpAxis> up) {}

    /** Normals as the scene has them: those of its surface. */
    public static final String OWN = "own";

    public static final List<String> NAMES =
            List.of("sphere", "torus", "revolution", "vase", "cube");
    public static final List<String> NORMALS = List.of(OWN, "plain", "area", "angle");
    public static final int COARSEST = 4;
    public static final int FINEST = 64;

    @JsonCreator
    public LitBody(
            @JsonProperty("name") String name,
            @JsonProperty("detail") int detail,
            @JsonProperty("normals") String normals) {
        this(name, detail, normals, Optional.empty());
    }

    static LitBody opened(Path file, Scene scene) {
        return opened(file, scene, Optional.empty());
    }

    static LitBody model(Path file, Scene scene, UpAxis up) {
        return opened(file, scene, Optional.of(up));
    }

    private static LitBody opened(Path file, Scene scene, Optional<UpAxis> up) {
        var opened = new OpenedScene(file.toAbsolutePath(), scene, up);
        return new LitBody(String.valueOf(file.getFileName()), COARSEST, OWN, Optional.of(opened));
    }

    /** The axis of a model that points up; empty where no model is lit. */
    public Optional<UpAxis> up() {
        return opened.flatMap(OpenedScene::up);
    }

    public LitBody withNormals(String other) {
        return new LitBody(name, detail, other, opened);
    }

    /** Whether its normals are those that the user's own program finds. */
    boolean asksProgram() {
        return normals.equals(OwnMethods.NAME);
    }

    /** The name without a file's ending. */
    public String stem() {
        return name.replaceFirst("(\\.scene)?\\.[a-zA-Z]+$", "")
                .replaceAll("[^\\p{L}\\p{N}_-]", "-");
    }

    public boolean hasDetail() {
        return opened.isEmpty() && Scenes.namesWithDetail().contains(name);
    }

    /**
     * The body's faces with their normals; takes long for many faces. Where the user's own program
     * is to find the normals, they are the scene's own: {@link #scene(VertexNormals)} asks it.
     */
    public Scene scene() {
        Scene bare = bare();
        boolean known = !normals.equals(OWN) && !asksProgram();
        return known ? smoothed(bare, new NormalsTopic().method(normals).implementation()) : bare;
    }

    /** The body's faces with the normals that a method finds. */
    Scene scene(VertexNormals method) {
        return smoothed(bare(), method);
    }

    private Scene bare() {
        if (opened.isPresent()) return opened.get().scene();
        if (TopicBodies.has(name)) return TopicBodies.scene(name);
        return hasDetail() ? Scenes.named(name, detail) : Scenes.named(name);
    }

    private static Scene smoothed(Scene scene, VertexNormals method) {
        return withMesh(scene, SmoothedMesh.of(scene.mesh(), method));
    }

    private static Scene withMesh(Scene scene, Mesh mesh) {
        return new Scene(
                scene.name(),
                mesh,
                scene.finishes(),
                scene.finishOf(),
                scene.light(),
                scene.backgroundRgb(),
                scene.defaultCamera(),
                scene.pictureScale());
    }
}
