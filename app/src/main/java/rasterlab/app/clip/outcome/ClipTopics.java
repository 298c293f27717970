package rasterlab.app.clip.outcome;

import java.util.List;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.clip.polygon.PolygonClipTopic;
import rasterlab.engine.clip.polygon.PolygonInWindow;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.clip.segment.SegmentsInWindow;
import rasterlab.engine.clip.segment.SteppedSegmentClipper;
import rasterlab.engine.clip.volume.SegmentsInVolume;
import rasterlab.engine.clip.volume.SteppedVolumeClipper;
import rasterlab.engine.clip.volume.VolumeClipTopic;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/** The engine's topics that the lab shows, one for each mode. */
public record ClipTopics(
        SegmentClipTopic segments,
        PolygonClipTopic polygon,
        VolumeClipTopic volume,
        OwnMethods own) {
    /** The lab of somebody who has written no program. */
    public ClipTopics() {
        this(new OwnMethods());
    }

    public ClipTopics(OwnMethods own) {
        this(new SegmentClipTopic(), new PolygonClipTopic(), new VolumeClipTopic(), own);
    }

    Topic<?, ?, ?> of(ClipMode mode) {
        return switch (mode) {
            case SEGMENTS -> segments;
            case POLYGON -> polygon;
            case VOLUME -> volume;
        };
    }

    public List<String> methods(ClipMode mode) {
        return of(mode).methods().stream().map(Method::name).toList();
    }

    /**
     * @throws IllegalArgumentException naming the methods there are
     */
    public Method<?> method(ClipMode mode, String name) {
        return own.method(of(mode), name);
    }

    public List<? extends Hazard<?>> hazards(ClipMode mode) {
        return of(mode).hazards();
    }

    /** The scene with a hazard's input in the place of its own. */
    public ClipScene showing(ClipScene scene, String hazard) {
        List<Hazard<?>> hazards = List.copyOf(hazards(scene.mode()));
        return showing(scene, Named.find("hazard", hazard, hazards, Hazard::name).input());
    }

    /** The scene with another input of its topic in the place of its own. */
    public static ClipScene showing(ClipScene scene, Object input) {
        if (scene instanceof SegmentScene old) return old.showing((SegmentsInWindow) input);
        if (scene instanceof PolygonClipScene old) return old.showing((PolygonInWindow) input);
        return ((VolumeScene) scene).showing((SegmentsInVolume) input);
    }

    /** The formula of a method's decision variable; "" for one without. */
    public static String decisionFormula(Method<?> method) {
        if (method.implementation() instanceof SteppedSegmentClipper stepped)
            return stepped.decisionFormula();
        return method.implementation() instanceof SteppedVolumeClipper stepped
                ? stepped.decisionFormula()
                : "";
    }
}
