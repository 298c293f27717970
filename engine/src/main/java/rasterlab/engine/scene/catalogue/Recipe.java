package rasterlab.engine.scene.catalogue;

import java.util.function.IntFunction;
import java.util.function.Supplier;
import rasterlab.engine.scene.Scene;

/**
 * How a scene is made.
 *
 * @param name of the scene
 * @param usualDetail steps once round its surfaces; 0 where it has none that are made in steps
 * @param make the scene in some detail
 */
record Recipe(String name, int usualDetail, IntFunction<Scene> make) {
    static final int COARSEST = 3;
    static final int FINEST = 1024;

    static Recipe plain(String name, Supplier<Scene> make) {
        return new Recipe(name, 0, detail -> make.get());
    }

    boolean hasDetail() {
        return usualDetail > 0;
    }

    Scene usual() {
        return make.apply(usualDetail);
    }

    Scene inDetail(int detail) {
        if (!hasDetail())
            throw new IllegalArgumentException(
                    "scene '%s' takes no detail; %s do"
                            .formatted(name, String.join(", ", Scenes.namesWithDetail())));
        if (detail < COARSEST || detail > FINEST)
            throw new IllegalArgumentException(
                    "detail must be from %d to %d, got %d".formatted(COARSEST, FINEST, detail));
        return make.apply(detail);
    }
}
