package rasterlab.exercises.scene;

import java.util.OptionalInt;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;

/** Where a view's scene comes from. */
public sealed interface SceneSource {
    Scene scene();

    /**
     * One that the lab has.
     *
     * @param detail as {@link Scenes#named(String, int)} takes it
     */
    record ByName(String name, OptionalInt detail) implements SceneSource {
        public ByName {
            found(name, detail);
        }

        @Override
        public Scene scene() {
            return found(name, detail);
        }

        private static Scene found(String name, OptionalInt detail) {
            return detail.isPresent() ? Scenes.named(name, detail.getAsInt()) : Scenes.named(name);
        }
    }

    /** One that the file itself holds; it has no textures. */
    record Inline(Scene scene) implements SceneSource {
        public Inline {
            if (scene.finishes().stream().anyMatch(finish -> finish.texture().isPresent()))
                throw new IllegalArgumentException(
                        "scene '%s' has textures; a scene file holds none".formatted(scene.name()));
        }
    }
}
