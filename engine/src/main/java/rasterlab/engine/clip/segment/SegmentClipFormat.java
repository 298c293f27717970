package rasterlab.engine.clip.segment;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.GivenWindow;
import rasterlab.engine.clip.PartCapture;
import rasterlab.engine.clip.PartFormat;
import rasterlab.engine.clip.polygon.ConvexWindow;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;

/**
 * Clipped segments from outside: {@code window} by its sides, or for {@code cyrus-beck} the corners
 * of a convex polygon, {@code segments}; {@code segments} out.
 */
public final class SegmentClipFormat extends Format<SegmentClipper, SegmentsInWindow, ClippedEnds> {
    private static final Field<double[]> SEGMENTS =
            Field.required("segments", Shape.points(4, 0, PartFormat.MOST)).as(FieldKind.SEGMENTS);
    private static final Field<?> PARTS = PartFormat.segments(4).as(FieldKind.SEGMENTS);

    public SegmentClipFormat(Topic<SegmentClipper, SegmentsInWindow, ClippedEnds> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(GivenWindow.FIELD, SEGMENTS);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(PARTS);
    }

    @Override
    public String reads() {
        return """
            {"window":[xmin,ymin,xmax,ymax], "segments":[[x0,y0,x1,y1],...]}; cyrus-beck \
            also takes the corners of a convex polygon as window""";
    }

    @Override
    public String answers() {
        return """
            {"segments":[...]} in their order, null where nothing is left""";
    }

    @Override
    public SegmentsInWindow read(Given given) {
        GivenWindow window = given.get(GivenWindow.FIELD);
        if (!window.upright()) throw given.invalid("window", "expected [xmin,ymin,xmax,ymax]");
        double[] sides = window.numbers();
        return new SegmentsInWindow(
                new ClipWindow(sides[0], sides[1], sides[2], sides[3]),
                PartFormat.rows(given.get(SEGMENTS), 4));
    }

    @Override
    protected Given given(SegmentsInWindow input) {
        return new Given()
                .with(GivenWindow.FIELD, new GivenWindow(true, input.window().sides()))
                .with(SEGMENTS, PartFormat.numbers(input.segments()));
    }

    @Override
    public void write(SegmentsInWindow input, ClippedEnds left, ValueSink out) throws IOException {
        PartFormat.write(left.parts(), out);
    }

    /** {@inheritDoc} By a polygon clips only the method that takes any. */
    @Override
    public Supplier<Written> prepared(Call<SegmentClipper> call, Given given) {
        GivenWindow window = given.get(GivenWindow.FIELD);
        if (window.upright()) return super.prepared(call, given);
        List<double[]> segments = PartFormat.rows(given.get(SEGMENTS), 4);
        if (call.steps()) PartFormat.requireFewStepped(segments.size());
        return () -> inPolygon(call, window.numbers(), segments);
    }

    @Override
    protected void check(Call<SegmentClipper> call, SegmentsInWindow input) {
        if (call.steps()) PartFormat.requireFewStepped(input.segments().size());
    }

    @Override
    protected ClippedEnds recorded(Call<SegmentClipper> call, SegmentsInWindow input) {
        try {
            return super.recorded(call, input);
        } catch (LimitReached endless) {
            throw PartFormat.doesNotEnd(call.name(), SegmentClipTopic.MOST_STEPS);
        }
    }

    @Override
    protected Written steps(Call<SegmentClipper> call, SegmentsInWindow input) {
        SteppedSegmentClipper stepped = call.stepped(SteppedSegmentClipper.class);
        return steps(
                stepped, input.segments(), s -> SegmentClipTopic.walk(stepped, input.window(), s));
    }

    private Written inPolygon(
            Call<SegmentClipper> call, double[] corners, List<double[]> segments) {
        CyrusBeck method = cyrusBeck(call.method());
        // Where there are no segments, nobody else looks at the window.
        ConvexWindow.of(corners);
        var capture = new PartCapture(Integer.MAX_VALUE);
        for (double[] s : segments) {
            method.clip(corners, s[0], s[1], s[2], s[3], capture);
            capture.next();
        }
        ClippedEnds left = capture.captured();
        if (!call.steps()) return out -> PartFormat.write(left.parts(), out);
        RecordedSteps steps =
                steps(method, segments, s -> method.walk(corners, s[0], s[1], s[2], s[3]));
        return out -> {
            PartFormat.write(left.parts(), out);
            steps.write(out);
        };
    }

    /** The method as the one that takes any convex window. */
    private CyrusBeck cyrusBeck(SegmentClipper clipper) {
        if (clipper instanceof CyrusBeck any) return any;
        String takes =
                topic().methods().stream()
                        .filter(each -> each.implementation() instanceof CyrusBeck)
                        .map(Method::name)
                        .collect(Collectors.joining(", "));
        throw new IllegalArgumentException(
                "window must be [xmin,ymin,xmax,ymax]; the corners of a convex polygon are taken"
                        + " by "
                        + takes);
    }

    private static RecordedSteps steps(
            SteppedSegmentClipper method,
            List<double[]> segments,
            Function<double[], SegmentWalk> walk) {
        return RecordedSteps.decidingLists(
                method.decisionFormula(),
                segments.stream().map(s -> drained(walk.apply(s))).toList());
    }

    /** The walk, which is known to end, and that it was handed over, if it was. */
    private static List<PartFormat.SegmentStep> drained(SegmentWalk walk) {
        var steps = new ArrayList<PartFormat.SegmentStep>();
        while (walk.advance()) steps.add(step(walk.at(), walk.decision(), walk));
        if (walk.unsure()) steps.add(step("without rounding", Double.NaN, walk));
        return steps;
    }

    private static PartFormat.SegmentStep step(String at, double decision, SegmentWalk walk) {
        var left = new double[4];
        walk.piece(
                (x0, y0, x1, y1) -> {
                    left[0] = x0;
                    left[1] = y0;
                    left[2] = x1;
                    left[3] = y1;
                });
        return new PartFormat.SegmentStep(at, decision, left);
    }
}
