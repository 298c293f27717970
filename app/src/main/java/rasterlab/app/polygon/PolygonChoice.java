package rasterlab.app.polygon;

import java.util.EnumMap;
import java.util.Map;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonScene;

/**
 * The user's choice, which undo brings back; each mode keeps its own scene.
 *
 * @param difference whether two methods are shown in one picture with where they differ, instead of
 *     side by side
 */
public record PolygonChoice(
        PolygonMode mode, Map<PolygonMode, PolygonScene> scenes, boolean difference) {
    public PolygonChoice {
        scenes = Map.copyOf(scenes);
    }

    static PolygonChoice first() {
        var scenes = new EnumMap<PolygonMode, PolygonScene>(PolygonMode.class);
        for (PolygonMode mode : PolygonMode.values()) scenes.put(mode, PolygonScene.first(mode));
        return new PolygonChoice(PolygonMode.TRIANGLE, scenes, false);
    }

    /** The scene of the chosen mode. */
    public PolygonScene scene() {
        return scenes.get(mode);
    }

    PolygonChoice in(PolygonMode other) {
        return new PolygonChoice(other, scenes, difference);
    }

    /** The choice with that scene in its mode, which becomes the chosen one. */
    PolygonChoice with(PolygonScene scene) {
        var changed = new EnumMap<>(scenes);
        changed.put(scene.mode(), scene);
        return new PolygonChoice(scene.mode(), changed, difference);
    }

    PolygonChoice withDifference(boolean shown) {
        return new PolygonChoice(mode, scenes, shown);
    }
}
