package rasterlab.app.light;

import com.fasterxml.jackson.annotation.JsonCreator;
import com.fasterxml.jackson.annotation.JsonIgnore;
import com.fasterxml.jackson.annotation.JsonProperty;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SmoothedMesh;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.obj.UpAxis;

/**
 * What is lit.
 *
 * @param name of a scene, or {@code TOPIC/HAZARD}
 * @param detail faces once round, for a scene that is made in steps
 * @param normals {@value #OWN}, or a method of topic {@code vertex-normals}
 * @param opened the scene of a file; kept as long as the program runs
 */
record Body(String name, int detail, String normals, @JsonIgnore Optional<OpenedScene> opened) {
    /**
     * @param file where it was read from, an absolute path
     * @param up the axis of a model that points up; empty for a scene file
     */
    record OpenedScene(Path file, Scene scene, Optional<UpAxis> up) {}

    /** Normals as the scene has them: those of its surface. */
    static final String OWN = "own";

    static final List<String> NAMES = List.of("sphere", "torus", "revolution", "vase", "cube");
    static final List<String> NORMALS = List.of(OWN, "plain", "area", "angle");
    static final int COARSEST = 4;
    static final int FINEST = 64;

    @JsonCreator
    Body(
            @JsonProperty("name") String name,
            @JsonProperty("detail") int detail,
            @JsonProperty("normals") String normals) {
        this(name, detail, normals, Optional.empty());
    }

    static Body opened(Path file, Scene scene) {
        return opened(file, scene, Optional.empty());
    }

    static Body model(Path file, Scene scene, UpAxis up) {
        return opened(file, scene, Optional.of(up));
    }

    private static Body opened(Path file, Scene scene, Optional<UpAxis> up) {
        var opened = new OpenedScene(file.toAbsolutePath(), scene, up);
        return new Body(String.valueOf(file.getFileName()), COARSEST, OWN, Optional.of(opened));
    }

    /** The axis of a model that points up; empty where no model is lit. */
    Optional<UpAxis> up() {
        return opened.flatMap(OpenedScene::up);
    }

    Body withNormals(String other) {
        return new Body(name, detail, other, opened);
    }

    /** The name without a file's ending. */
    String stem() {
        return name.replaceFirst("(\\.scene)?\\.[a-zA-Z]+$", "")
                .replaceAll("[^\\p{L}\\p{N}_-]", "-");
    }

    boolean hasDetail() {
        return opened.isEmpty() && Scenes.namesWithDetail().contains(name);
    }

    /** Its faces with their normals; takes long for many faces. */
    Scene scene() {
        if (opened.isPresent()) return smoothed(opened.get().scene());
        if (TopicBodies.has(name)) return smoothed(TopicBodies.scene(name));
        Scene scene = hasDetail() ? Scenes.named(name, detail) : Scenes.named(name);
        return smoothed(scene);
    }

    private Scene smoothed(Scene scene) {
        return withMesh(scene, method().map(m -> SmoothedMesh.of(scene.mesh(), m)));
    }

    private Optional<VertexNormals> method() {
        if (normals.equals(OWN)) return Optional.empty();
        return Optional.of(new NormalsTopic().method(normals).implementation());
    }

    private static Scene withMesh(Scene scene, Optional<Mesh> mesh) {
        return new Scene(
                scene.name(),
                mesh.orElse(scene.mesh()),
                scene.finishes(),
                scene.finishOf(),
                scene.light(),
                scene.backgroundRgb(),
                scene.defaultCamera(),
                scene.pictureScale());
    }
}
