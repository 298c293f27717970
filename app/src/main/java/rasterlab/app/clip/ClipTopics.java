package rasterlab.app.clip;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import rasterlab.engine.clip.polygon.PolygonClipTopic;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.clip.segment.SteppedSegmentClipper;
import rasterlab.engine.clip.volume.SteppedVolumeClipper;
import rasterlab.engine.clip.volume.VolumeClipTopic;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** The engine's topics that the lab shows, one for each mode. */
public record ClipTopics(
        SegmentClipTopic segments, PolygonClipTopic polygon, VolumeClipTopic volume) {
    public ClipTopics() {
        this(new SegmentClipTopic(), new PolygonClipTopic(), new VolumeClipTopic());
    }

    Topic<?, ?, ?> of(ClipMode mode) {
        return switch (mode) {
            case SEGMENTS -> segments;
            case POLYGON -> polygon;
            case VOLUME -> volume;
        };
    }

    List<String> methods(ClipMode mode) {
        return of(mode).methods().stream().map(Method::name).toList();
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    Method<?> method(ClipMode mode, String name) {
        return of(mode).method(name);
    }

    List<? extends Hazard<?>> hazards(ClipMode mode) {
        return of(mode).hazards();
    }

    /** The scene with a hazard's input in the place of its own. */
    ClipScene showing(ClipScene scene, String hazard) {
        if (scene instanceof SegmentScene old)
            return old.showing(named(segments.hazards(), hazard).input());
        if (scene instanceof PolygonScene old)
            return old.showing(named(polygon.hazards(), hazard).input());
        return ((VolumeScene) scene).showing(named(volume.hazards(), hazard).input());
    }

    private static <I> Hazard<I> named(List<Hazard<I>> hazards, String name) {
        Map<String, Hazard<I>> byName =
                hazards.stream().collect(Collectors.toMap(Hazard::name, each -> each));
        if (!byName.containsKey(name))
            throw new IllegalArgumentException("no hazard is called '" + name + "'");
        return byName.get(name);
    }

    /** What the decision variable of a method is, as a formula; "" for one without. */
    static String decisionFormula(Method<?> method) {
        if (method.implementation() instanceof SteppedSegmentClipper stepped)
            return stepped.decisionFormula();
        return method.implementation() instanceof SteppedVolumeClipper stepped
                ? stepped.decisionFormula()
                : "";
    }
}
