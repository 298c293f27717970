package rasterlab.app.cli.run;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.PartCapture;
import rasterlab.engine.clip.polygon.ConvexWindow;
import rasterlab.engine.clip.segment.ClipWindow;
import rasterlab.engine.clip.segment.CyrusBeck;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.clip.segment.SegmentWalk;
import rasterlab.engine.clip.segment.SegmentsInWindow;
import rasterlab.engine.clip.segment.SteppedSegmentClipper;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/**
 * Topic {@code clip-segment}: {@code window} as [xmin,ymin,xmax,ymax], or for {@code cyrus-beck}
 * the corners of a convex polygon, {@code segments}; {@code segments} out.
 */
public final class ClipSegmentRun implements TopicRun {
    private static final JsonField<WindowJson> WINDOW = WindowJson.field();
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
                {"window":[xmin,ymin,xmax,ymax], "segments":[[x0,y0,x1,y1],...]}; cyrus-beck \
                also takes the corners of a convex polygon as window""",
                """
                {"segments":[...]} in their order, null where nothing is left""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, WINDOW, SEGMENTS);
        List<double[]> segments = ClipRun.rows(given.get(SEGMENTS), 4);
        WindowJson window = given.get(WINDOW);
        SegmentClipper clipper = topic.method(method).implementation();
        if (steps) ClipRun.requireFewStepped(segments.size());
        return ClipRun.watched(
                watch,
                method,
                SegmentClipTopic.MOST_STEPS,
                () ->
                        window.rectangle()
                                .map(sides -> inRectangle(method, clipper, sides, segments, steps))
                                .orElseGet(
                                        () ->
                                                inPolygon(
                                                        cyrusBeck(method, clipper),
                                                        window.corners(),
                                                        segments,
                                                        steps)));
    }

    private Answer inRectangle(
            String method,
            SegmentClipper clipper,
            ClipWindow window,
            List<double[]> segments,
            boolean steps) {
        ClippedEnds left =
                topic.record(clipper, new SegmentsInWindow(window, segments), Integer.MAX_VALUE);
        if (!steps) return json -> ClipRun.writeParts(json, left.parts());
        SteppedSegmentClipper stepped = Steps.of(method, clipper, SteppedSegmentClipper.class);
        return stepped(stepped, left, segments, s -> SegmentClipTopic.walk(stepped, window, s));
    }

    /**
     * The method as the one that takes any convex window.
     *
     * @throws Complaint if it is another
     */
    private CyrusBeck cyrusBeck(String method, SegmentClipper clipper) {
        if (clipper instanceof CyrusBeck any) return any;
        String takes =
                topic.methods().stream()
                        .filter(each -> each.implementation() instanceof CyrusBeck)
                        .map(Method::name)
                        .collect(Collectors.joining(", "));
        throw Complaint.refused(
                method
                        + " refuses: window must be [xmin,ymin,xmax,ymax]; the corners of a convex"
                        + " polygon are taken by "
                        + takes);
    }

    private static Answer inPolygon(
            CyrusBeck method, double[] corners, List<double[]> segments, boolean steps) {
        // Where there are no segments, nobody else looks at the window.
        ConvexWindow.of(corners);
        var capture = new PartCapture(Integer.MAX_VALUE);
        for (double[] s : segments) {
            method.clip(corners, s[0], s[1], s[2], s[3], capture);
            capture.next();
        }
        ClippedEnds left = capture.captured();
        if (!steps) return json -> ClipRun.writeParts(json, left.parts());
        return stepped(method, left, segments, s -> method.walk(corners, s[0], s[1], s[2], s[3]));
    }

    private static Answer stepped(
            SteppedSegmentClipper method,
            ClippedEnds left,
            List<double[]> segments,
            Function<double[], SegmentWalk> walk) {
        var walked = segments.stream().map(s -> steps(walk.apply(s))).toList();
        return json -> {
            ClipRun.writeParts(json, left.parts());
            Steps.writeLists(
                    json, method.decisionFormula(), walked, (out, step) -> step.write(out));
        };
    }

    /** The walk, which is known to end, and that it was handed over, if it was. */
    private static List<ClipRun.Step> steps(SegmentWalk walk) {
        var steps = new ArrayList<ClipRun.Step>();
        while (walk.advance()) steps.add(step(walk.at(), walk.decision(), walk));
        if (walk.unsure()) steps.add(step("without rounding", Double.NaN, walk));
        return steps;
    }

    private static ClipRun.Step step(String at, double decision, SegmentWalk walk) {
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
