package rasterlab.app.clip.outcome;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.engine.clip.ClippedEnds;

/**
 * The results of both methods for one scene, beside the one exact answer.
 *
 * @param exact coordinates of what is left, part after part
 * @param clipping by the chosen method
 * @param other by the second method, if one is compared
 */
public record ClipResults(
        ClipScene scene, List<double[]> exact, Clipping clipping, Optional<Clipping> other) {
    public static ClipResults of(ClipTopics topics, ClipScene scene) {
        if (scene instanceof SegmentScene segments) return of(topics, segments);
        if (scene instanceof VolumeScene volume) return of(topics, volume);
        return of(topics, (PolygonClipScene) scene);
    }

    private static ClipResults of(ClipTopics topics, SegmentScene scene) {
        ClippedEnds exact = SegmentClipping.exact(topics.segments(), scene);
        return of(
                scene,
                present(exact),
                method ->
                        SegmentClipping.of(
                                topics.own().in(topics.segments()), scene, method, exact));
    }

    private static ClipResults of(ClipTopics topics, PolygonClipScene scene) {
        List<double[]> exact = PolygonClipping.exact(topics.polygon(), scene);
        return of(
                scene,
                exact,
                method ->
                        PolygonClipping.of(
                                topics.own().in(topics.polygon()), scene, method, exact));
    }

    private static ClipResults of(ClipTopics topics, VolumeScene scene) {
        ClippedEnds exact = VolumeClipping.exact(topics.volume(), scene);
        return of(
                scene,
                present(exact),
                method ->
                        VolumeClipping.of(topics.own().in(topics.volume()), scene, method, exact));
    }

    private static ClipResults of(
            ClipScene scene, List<double[]> exact, Function<String, Clipping> clipped) {
        Optional<Clipping> other =
                scene.comparison().isEmpty()
                        ? Optional.empty()
                        : Optional.of(clipped.apply(scene.comparison()));
        return new ClipResults(scene, exact, clipped.apply(scene.method()), other);
    }

    /** Size of the window or volume. */
    public double unit() {
        if (scene instanceof SegmentScene segments) return segments.window().rectangle().unit();
        return scene instanceof PolygonClipScene polygon ? polygon.window().rectangle().unit() : 1;
    }

    private static List<double[]> present(ClippedEnds ends) {
        return ends.parts().stream().flatMap(Optional::stream).toList();
    }
}
