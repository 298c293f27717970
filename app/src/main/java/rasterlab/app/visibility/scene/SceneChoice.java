package rasterlab.app.visibility.scene;

import com.fasterxml.jackson.annotation.JsonCreator;
import com.fasterxml.jackson.annotation.JsonValue;
import java.nio.file.Path;
import java.util.Optional;
import rasterlab.app.model.TextureChange;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.texture.Texture;

/**
 * The scene that is looked at.
 *
 * @param name one of {@link Scenes#names()}, or the file's
 * @param file where it was read from; empty for a scene that the lab has
 * @param image the picture laid on all its faces, where one was opened
 * @param up the axis of a model that points up; empty where no model is shown
 * @param known whether the name brings the scene back, image and all
 * @param given the input of a topic that the scene shows; empty for any other scene
 */
public record SceneChoice(
        String name,
        Optional<Path> file,
        Optional<Path> image,
        Scene scene,
        Optional<UpAxis> up,
        boolean known,
        Optional<Object> given) {
    /**
     * @throws IllegalArgumentException for an unknown name
     */
    @JsonCreator
    static SceneChoice named(String name) {
        return new SceneChoice(
                name,
                Optional.empty(),
                Optional.empty(),
                Scenes.named(name),
                Optional.empty(),
                true,
                Optional.empty());
    }

    /** A scene that is neither the lab's nor a file's. */
    static SceneChoice of(Scene scene) {
        return new SceneChoice(
                scene.name(),
                Optional.empty(),
                Optional.empty(),
                scene,
                Optional.empty(),
                false,
                Optional.empty());
    }

    /** This scene, which shows that input of a topic. */
    SceneChoice showing(Object input) {
        return new SceneChoice(name, file, image, scene, up, known, Optional.of(input));
    }

    /**
     * The name by which {@link #named} finds it; only scenes that the lab has are kept between
     * runs.
     */
    @JsonValue
    String kept() {
        return name;
    }

    /** Whether {@code ./lab render} finds the scene by its name; a picture on it has its own. */
    public boolean named() {
        return known || file.isEmpty() && image.isPresent() && Scenes.names().contains(name);
    }

    /** The lab's scene that a picture is laid on; empty where the scene is not the lab's. */
    Optional<SceneChoice> withoutFiles() {
        return file.isEmpty() && Scenes.names().contains(name)
                ? Optional.of(named(name))
                : Optional.empty();
    }

    static SceneChoice opened(Path file, Scene scene) {
        return opened(file, scene, Optional.empty());
    }

    static SceneChoice model(Path file, Scene scene, UpAxis up) {
        return opened(file, scene, Optional.of(up));
    }

    private static SceneChoice opened(Path file, Scene scene, Optional<UpAxis> up) {
        return new SceneChoice(
                file.getFileName().toString(),
                Optional.of(file),
                Optional.empty(),
                scene,
                up,
                false,
                Optional.empty());
    }

    /**
     * @throws IllegalArgumentException if the scene has no place for a texture
     */
    SceneChoice covered(Path picture, Texture texture) {
        return new SceneChoice(
                name,
                file,
                Optional.of(picture),
                TextureChange.covered(scene, texture),
                up,
                false,
                given);
    }

    public boolean textured() {
        return scene.finishes().stream().anyMatch(finish -> finish.texture().isPresent());
    }

    /** The fewest components of a texture; 4 where there is none. */
    public int fewestComponents() {
        return scene.finishes().stream()
                .flatMap(finish -> finish.texture().stream())
                .mapToInt(laid -> laid.texture().components())
                .min()
                .orElse(4);
    }
}
