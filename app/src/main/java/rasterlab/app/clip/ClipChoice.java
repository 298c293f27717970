package rasterlab.app.clip;

import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.VolumeScene;

/**
 * The user's choice, which undo brings back; each mode keeps its own scene.
 *
 * @param difference whether two methods are shown in one picture with what only one of them left,
 *     instead of side by side
 */
public record ClipChoice(
        ClipMode mode,
        SegmentScene segments,
        PolygonClipScene polygon,
        VolumeScene volume,
        boolean difference) {
    static final ClipChoice FIRST =
            new ClipChoice(
                    ClipMode.SEGMENTS,
                    SegmentScene.first(),
                    PolygonClipScene.first(),
                    VolumeScene.first(),
                    false);

    /** The scene of the chosen mode. */
    public ClipScene scene() {
        return switch (mode) {
            case SEGMENTS -> segments;
            case POLYGON -> polygon;
            case VOLUME -> volume;
        };
    }

    /** The first scene of the same mode. */
    ClipScene firstScene() {
        return FIRST.in(mode).scene();
    }

    ClipChoice in(ClipMode other) {
        return new ClipChoice(other, segments, polygon, volume, difference);
    }

    /** The choice with that scene in its mode, which becomes the chosen one. */
    ClipChoice with(ClipScene scene) {
        return new ClipChoice(
                scene.mode(),
                scene instanceof SegmentScene other ? other : segments,
                scene instanceof PolygonClipScene other ? other : polygon,
                scene instanceof VolumeScene other ? other : volume,
                difference);
    }

    ClipChoice withDifference(boolean shown) {
        return new ClipChoice(mode, segments, polygon, volume, shown);
    }
}
