package rasterlab.app.cli.run;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.clip.ClipWalk;
import rasterlab.engine.clip.ClipWindow;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.SegmentClipTopic;
import rasterlab.engine.clip.SegmentsInWindow;
import rasterlab.engine.clip.SteppedSegmentClipper;
import rasterlab.engine.study.Topic;

/** Topic {@code clip-segment}: {@code window}, {@code segments}; {@code segments} out. */
public final class ClipSegmentRun implements TopicRun {
    private static final JsonField<ClipWindow> WINDOW =
            JsonField.required("window", ClipRun.window());
    private static final JsonField<double[]> SEGMENTS =
            JsonField.required("segments", json -> json.points(4, 0, ClipRun.MOST));

    private final Topic<SegmentClipper, SegmentsInWindow, ClippedEnds> topic;
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    ClipSegmentRun(Watch watch) {
        this(watch, new SegmentClipTopic());
    }

    ClipSegmentRun(Watch watch, Topic<SegmentClipper, SegmentsInWindow, ClippedEnds> topic) {
        this.watch = watch;
        this.topic = topic;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"window":[xmin,ymin,xmax,ymax], "segments":[[x0,y0,x1,y1],...]}""",
                """
                {"segments":[...]} in their order, null where nothing is left""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, WINDOW, SEGMENTS);
        List<double[]> segments = ClipRun.rows(given.get(SEGMENTS), 4);
        var input = new SegmentsInWindow(given.get(WINDOW), segments);
        SegmentClipper clipper = topic.method(method).implementation();
        if (steps) ClipRun.requireFewStepped(segments.size());
        return ClipRun.watched(
                watch,
                method,
                SegmentClipTopic.MOST_STEPS,
                () -> clipped(method, clipper, input, steps));
    }

    private Answer clipped(
            String method, SegmentClipper clipper, SegmentsInWindow input, boolean steps) {
        ClippedEnds left = topic.record(clipper, input, Integer.MAX_VALUE);
        if (!steps) return json -> ClipRun.writeParts(json, left.parts());
        SteppedSegmentClipper stepped = Steps.of(method, clipper, SteppedSegmentClipper.class);
        var walks = input.segments().stream().map(s -> steps(stepped, input.window(), s)).toList();
        return json -> {
            ClipRun.writeParts(json, left.parts());
            Steps.writeLists(
                    json, stepped.decisionFormula(), walks, (out, step) -> step.write(out));
        };
    }

    /** The walk, which is known to end, and that it was handed over, if it was. */
    private static List<ClipRun.Step> steps(
            SteppedSegmentClipper method, ClipWindow window, double[] segment) {
        var steps = new ArrayList<ClipRun.Step>();
        ClipWalk walk = SegmentClipTopic.walk(method, window, segment);
        while (walk.advance()) steps.add(step(walk.at(), walk.decision(), walk));
        if (walk.unsure()) steps.add(step("without rounding", Double.NaN, walk));
        return steps;
    }

    private static ClipRun.Step step(String at, double decision, ClipWalk walk) {
        var left = new double[4];
        walk.piece(
                (x0, y0, x1, y1) -> {
                    left[0] = x0;
                    left[1] = y0;
                    left[2] = x1;
                    left[3] = y1;
                });
        return new ClipRun.Step(at, decision, left);
    }
}
