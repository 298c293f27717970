package rasterlab.app.clip.outcome;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.clip.scene.PlaneFigures;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.contract.PolygonClipper;
import rasterlab.engine.clip.polygon.PolygonClipTopic;
import rasterlab.engine.clip.polygon.PolygonInWindow;
import rasterlab.engine.clip.polygon.PolygonWalk;
import rasterlab.engine.clip.polygon.SteppedPolygonClipper;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Topic;

/** Clips the polygon of a scene step by step. */
public final class PolygonClipping {
    private PolygonClipping() {}

    private static PolygonInWindow input(PolygonClipScene scene) {
        return new PolygonInWindow(scene.window().xy(), PlaneFigures.xy(scene.subject()));
    }

    /** The pieces without rounding; none where window or subject are no proper input. */
    static List<double[]> exact(PolygonClipTopic topic, PolygonClipScene scene) {
        return topic.exact(input(scene), Integer.MAX_VALUE);
    }

    /**
     * @throws IllegalArgumentException if the topic has no method of that name
     */
    static Clipping of(
            Topic<PolygonClipper, PolygonInWindow, List<double[]>> topic,
            PolygonClipScene scene,
            String method,
            List<double[]> exact) {
        PolygonClipper clipper = topic.method(method).implementation();
        var steps = new ArrayList<ClipStep>();
        var pieces = new ArrayList<double[]>();
        try {
            if (clipper instanceof SteppedPolygonClipper stepped)
                clip(stepped, scene, steps, pieces);
            else {
                pieces.addAll(topic.record(clipper, input(scene), Integer.MAX_VALUE));
                pieces.stream().map(ClipStep::writtenPiece).forEach(steps::add);
            }
        } catch (IllegalArgumentException e) {
            return stopped(method, Clipping.ClipEnding.REFUSED, e.getMessage());
        } catch (RuntimeException e) {
            return stopped(method, Clipping.ClipEnding.CRASHED, e.toString());
        }
        return new Clipping(
                method,
                false,
                steps,
                pieces.stream().map(piece -> new Clipping.ClipPart(0, piece)).toList(),
                Clipping.ClipEnding.ENDED,
                "",
                topic.compare(input(scene), exact, pieces),
                WrongParts.between(edges(exact), edges(pieces), scene.window().rectangle().unit()));
    }

    private static Clipping stopped(String method, Clipping.ClipEnding ending, String message) {
        return new Clipping(
                method,
                false,
                List.of(),
                List.of(),
                ending,
                message,
                Deviation.NONE,
                WrongParts.NONE);
    }

    private static void clip(
            SteppedPolygonClipper method,
            PolygonClipScene scene,
            List<ClipStep> steps,
            List<double[]> pieces) {
        PolygonInWindow input = input(scene);
        PolygonWalk walk = method.walk(input.window(), input.subject());
        while (walk.advance()) steps.add(step(walk, steps.size()));
        walk.send(pieces::add);
    }

    private static ClipStep step(PolygonWalk walk, int made) {
        double[] passage = walk.passage();
        boolean bySides = passage.length == 0;
        return new ClipStep(
                0,
                walk.at(),
                bySides ? made : -1,
                walk.polygon().length / 2,
                bySides ? ClipStep.Passing.NONE : ClipStep.Passing.BOTH,
                passage,
                walk.polygon());
    }

    public static List<double[]> edges(List<double[]> pieces) {
        return pieces.stream().flatMap(piece -> Edges.around(piece).stream()).toList();
    }
}
