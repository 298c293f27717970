package rasterlab.app.clip.outcome;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.app.clip.scene.PlaneSegment;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.EndComparison;
import rasterlab.engine.clip.PartCapture;
import rasterlab.engine.clip.exact.ExactClip;
import rasterlab.engine.clip.polygon.ConvexWindow;
import rasterlab.engine.clip.segment.CohenSutherlandTextbook;
import rasterlab.engine.clip.segment.CyrusBeck;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.clip.segment.SegmentWalk;
import rasterlab.engine.clip.segment.SegmentsInWindow;
import rasterlab.engine.clip.segment.SteppedSegmentClipper;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Topic;

/** Clips the segments of a scene, each step by step. */
public final class SegmentClipping {
    private static final String UPRIGHT_ONLY =
            "window must be an upright rectangle; convex polygons are taken by cyrus-beck";

    private final SegmentScene scene;
    private final SteppedSegmentClipper method;
    private final List<Border> borders;

    private SegmentClipping(SegmentScene scene, SteppedSegmentClipper method) {
        this.scene = scene;
        this.method = method;
        borders =
                scene.window().upright()
                        ? Border.of(scene.window().rectangle())
                        : Border.convex(scene.window().xy());
    }

    /** The exact rest, without rounding; empty where the window is not convex. */
    static ClippedEnds exact(SegmentClipTopic topic, SegmentScene scene) {
        if (scene.window().upright()) return topic.exact(input(scene), scene.segments().size());
        double[] corners = scene.window().xy();
        boolean convex = isConvex(corners);
        return new ClippedEnds(
                scene.segments().stream()
                        .map(
                                segment ->
                                        convex
                                                ? ExactClip.convex(corners, segment.ends())
                                                : Optional.<double[]>empty())
                        .toList(),
                0);
    }

    public static boolean isConvex(double[] corners) {
        try {
            return ConvexWindow.of(corners).xy().length > 0;
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }

    private static SegmentsInWindow input(SegmentScene scene) {
        return new SegmentsInWindow(
                scene.window().rectangle(),
                scene.segments().stream().map(PlaneSegment::ends).toList());
    }

    /**
     * @throws IllegalArgumentException if the topic has no method of that name
     */
    static Clipping of(
            Topic<SegmentClipper, SegmentsInWindow, ClippedEnds> topic,
            SegmentScene scene,
            String method,
            ClippedEnds exact) {
        SegmentClipper clipper = topic.method(method).implementation();
        var run = new ClipRecord(method, decidesByCode(clipper));
        if (!scene.window().upright() && !(clipper instanceof CyrusBeck)) run.refuse(UPRIGHT_ONLY);
        else if (clipper instanceof SteppedSegmentClipper stepped)
            run.attempt(() -> new SegmentClipping(scene, stepped).clipAll(run));
        else run.attempt(() -> clipAll(clipper, scene, run));
        return run.clipping(exact, parts -> compare(topic, scene, exact, parts), unit(scene));
    }

    /** The topic's own comparison; an oblique border's new ends may lie outside by a rounding. */
    private static Deviation compare(
            Topic<SegmentClipper, SegmentsInWindow, ClippedEnds> topic,
            SegmentScene scene,
            ClippedEnds exact,
            ClippedEnds parts) {
        SegmentsInWindow input = input(scene);
        if (scene.window().upright()) return topic.compare(input, exact, parts);
        return EndComparison.compare(exact, parts, unit(scene), input.segments(), point -> true);
    }

    /** Whether the clipper decides by a code or by t, told by the formula of its decision. */
    private static boolean decidesByCode(SegmentClipper clipper) {
        return clipper instanceof SteppedSegmentClipper stepped
                && stepped.decisionFormula().startsWith("code");
    }

    private static double unit(SegmentScene scene) {
        return scene.window().rectangle().unit();
    }

    private void clipAll(ClipRecord run) {
        for (int i = 0; i < scene.segments().size(); i++) {
            int item = i;
            run.attempt(() -> clip(item, run));
            run.next();
        }
    }

    /** Clips by a method without steps, up to the first segment that it does not answer. */
    private static void clipAll(SegmentClipper method, SegmentScene scene, ClipRecord run) {
        for (int i = 0; i < scene.segments().size(); i++) {
            double[] ends = scene.segments().get(i).ends();
            SegmentClipTopic.clip(method, scene.window().rectangle(), ends, run.sink());
            run.written(i);
        }
    }

    private void clip(int item, ClipRecord run) {
        double[] ends = scene.segments().get(item).ends();
        SegmentWalk walk = walk(ends);
        for (int made = 0; walk.advance(); made++) {
            if (made == SegmentClipTopic.MOST_STEPS) {
                run.endless();
                return;
            }
            if (made < Clipping.RECORDED) run.add(step(item, ends, walk, made, run));
        }
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

    private SegmentWalk walk(double[] ends) {
        return !scene.window().upright() && method instanceof CyrusBeck any
                ? any.walk(scene.window().xy(), ends[0], ends[1], ends[2], ends[3])
                : SegmentClipTopic.walk(method, scene.window().rectangle(), ends);
    }

    private ClipStep step(int item, double[] ends, SegmentWalk walk, int made, ClipRecord run) {
        int border = border(walk.at(), made);
        double t = walk.decision();
        boolean middle = border < 0 && t >= 0 && t <= 1;
        return new ClipStep(
                item,
                walk.at(),
                border,
                t,
                border < 0 ? ClipStep.Passing.NONE : borders.get(border).passing(ends),
                border >= 0
                        ? borders.get(border).meeting(ends)
                        : middle ? Border.at(ends, t) : new double[0],
                run.remaining(ends, left(walk)));
    }

    private int border(String at, int made) {
        if (!scene.window().upright()) return made;
        int named = Border.SIDES.getOrDefault(at, -1);
        // The listing's y grows downward: its top side is at the smaller y.
        return method instanceof CohenSutherlandTextbook && named % 2 == 0 ? 2 - named : named;
    }

    private static double[] left(SegmentWalk walk) {
        var capture = new PartCapture(1);
        walk.piece(capture);
        capture.next();
        return capture.captured().parts().get(0).orElseThrow();
    }

    /** Region codes of the ends of one segment: 1 above, 2 below, 4 right, 8 left. */
    public static int[] codes(SegmentScene scene, int item) {
        PlaneSegment segment = scene.segments().get(item);
        return IntStream.range(0, 2)
                .map(
                        end ->
                                scene.window()
                                        .rectangle()
                                        .code(segment.end(end).x(), segment.end(end).y()))
                .toArray();
    }
}
