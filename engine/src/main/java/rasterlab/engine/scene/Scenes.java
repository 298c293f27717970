package rasterlab.engine.scene;

import java.util.List;

/** The scenes that can be named. */
public final class Scenes {
    private static final List<Scene> ALL = List.of(Vase.scene(), House.scene());

    private Scenes() {}

    /** All scenes, in teaching order. */
    public static List<Scene> all() {
        return ALL;
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static Scene named(String name) {
        return ALL.stream()
                .filter(scene -> scene.name().equals(name))
                .findFirst()
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "no scene '%s'; there are %s"
                                                .formatted(
                                                        name,
                                                        String.join(
                                                                ", ",
                                                                ALL.stream()
                                                                        .map(Scene::name)
                                                                        .toList()))));
    }
}
