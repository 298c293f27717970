package rasterlab.engine.scene;

import java.util.List;
import rasterlab.engine.naming.Named;

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
        return Named.find("scene", name, ALL, Scene::name);
    }
}
