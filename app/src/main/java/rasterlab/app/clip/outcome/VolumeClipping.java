package rasterlab.app.clip.outcome;

import java.util.List;
import rasterlab.app.clip.scene.SpaceSegment;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.contract.VolumeClipper;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.PartCapture;
import rasterlab.engine.clip.volume.DivideFirstTextbook;
import rasterlab.engine.clip.volume.SegmentsInVolume;
import rasterlab.engine.clip.volume.SteppedVolumeClipper;
import rasterlab.engine.clip.volume.VolumeClipTopic;
import rasterlab.engine.clip.volume.VolumeWalk;
import rasterlab.engine.study.Topic;

/** Clips the segments of a scene in space, each step by step. */
final class VolumeClipping {
    private final VolumeScene scene;
    private final SteppedVolumeClipper method;
    private final List<Border> borders;

    private VolumeClipping(VolumeScene scene, SteppedVolumeClipper method) {
        this.scene = scene;
        this.method = method;
        borders = Border.volume(scene.zmin());
    }

    /** The exact rest, without rounding. */
    static ClippedEnds exact(VolumeClipTopic topic, VolumeScene scene) {
        return topic.exact(input(scene), scene.segments().size());
    }

    private static SegmentsInVolume input(VolumeScene scene) {
        return new SegmentsInVolume(
                scene.zmin(), scene.segments().stream().map(SpaceSegment::ends).toList());
    }

    /**
     * @throws IllegalArgumentException if the topic has no method of that name
     */
    static Clipping of(
            Topic<VolumeClipper, SegmentsInVolume, ClippedEnds> topic,
            VolumeScene scene,
            String method,
            ClippedEnds exact) {
        VolumeClipper clipper = topic.method(method).implementation();
        var run = new ClipRecord(method, false);
        if (clipper instanceof SteppedVolumeClipper stepped)
            new VolumeClipping(scene, stepped).clipAll(run);
        else run.attempt(() -> clipAll(clipper, scene, run));
        return run.clipping(exact, parts -> topic.compare(input(scene), exact, parts), 1);
    }

    private void clipAll(ClipRecord run) {
        for (int i = 0; i < scene.segments().size(); i++) {
            int item = i;
            run.attempt(() -> clip(item, run));
            run.next();
        }
    }

    /** Clips by a method without steps, up to the first segment that it does not answer. */
    private static void clipAll(VolumeClipper method, VolumeScene scene, ClipRecord run) {
        for (int i = 0; i < scene.segments().size(); i++) {
            double[] ends = scene.segments().get(i).ends();
            VolumeClipTopic.clip(method, scene.zmin(), ends, run.sink());
            run.written(i);
        }
    }

    private void clip(int item, ClipRecord run) {
        double[] ends = scene.segments().get(item).ends();
        VolumeWalk walk = VolumeClipTopic.walk(method, scene.zmin(), ends);
        while (walk.advance()) run.add(step(item, ends, walk, run));
        if (walk.unsure())
            run.add(
                    new ClipStep(
                            item,
                            "without rounding",
                            -1,
                            Double.NaN,
                            ClipStep.Passing.NONE,
                            new double[0],
                            left(walk)));
        walk.send(run.sink());
    }

    private ClipStep step(int item, double[] ends, VolumeWalk walk, ClipRecord run) {
        int index = Border.PLANES.getOrDefault(walk.at(), -1);
        Border border = borders.get(Math.max(0, index));
        boolean told = index >= 0 && !Double.isNaN(walk.decision());
        return new ClipStep(
                item,
                walk.at(),
                index,
                walk.decision(),
                told ? border.passing(ends) : ClipStep.Passing.NONE,
                told && !(method instanceof DivideFirstTextbook)
                        ? border.meeting(ends)
                        : new double[0],
                run.remaining(ends, left(walk)));
    }

    private static double[] left(VolumeWalk walk) {
        var capture = new PartCapture(1);
        walk.piece(capture);
        capture.next();
        return capture.captured().parts().get(0).orElseThrow();
    }
}
