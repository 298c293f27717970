package rasterlab.engine.clip.volume;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.VolumeClipper;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.PartFormat;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.RecordedSteps;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.Written;
import rasterlab.engine.study.Call;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Topic;

/** Segments clipped in space from outside: {@code zmin}, {@code segments}; {@code segments} out. */
public final class VolumeClipFormat extends Format<VolumeClipper, SegmentsInVolume, ClippedEnds> {
    private static final Field<Double> ZMIN =
            Field.required(
                    "zmin",
                    Shape.described(Shape.number(), Shape.numberAbove(0, Math.nextDown(1.0))));
    private static final Field<double[]> SEGMENTS =
            Field.required("segments", Shape.points(6, 0, PartFormat.MOST));
    private static final Field<?> PARTS = PartFormat.segments(6);

    public VolumeClipFormat(Topic<VolumeClipper, SegmentsInVolume, ClippedEnds> topic) {
        super(topic);
    }

    @Override
    public List<Field<?>> input() {
        return List.of(ZMIN, SEGMENTS);
    }

    @Override
    public List<Field<?>> answer() {
        return List.of(PARTS);
    }

    @Override
    public String reads() {
        return """
            {"zmin":z, "segments":[[x0,y0,z0,x1,y1,z1],...]}, 0 < z < 1""";
    }

    @Override
    public String answers() {
        return """
            {"segments":[...]} in their order, null where nothing is left""";
    }

    @Override
    public SegmentsInVolume read(Given given) {
        try {
            return new SegmentsInVolume(given.get(ZMIN), PartFormat.rows(given.get(SEGMENTS), 6));
        } catch (IllegalArgumentException e) {
            throw given.invalid(e);
        }
    }

    @Override
    protected Given given(SegmentsInVolume input) {
        return new Given()
                .with(ZMIN, input.zmin())
                .with(SEGMENTS, PartFormat.numbers(input.segments()));
    }

    @Override
    public void write(SegmentsInVolume input, ClippedEnds left, ValueSink out) throws IOException {
        PartFormat.write(left.parts(), out);
    }

    @Override
    protected void check(Call<VolumeClipper> call, SegmentsInVolume input) {
        if (call.steps()) PartFormat.requireFewStepped(input.segments().size());
    }

    @Override
    protected ClippedEnds recorded(Call<VolumeClipper> call, SegmentsInVolume input) {
        try {
            return super.recorded(call, input);
        } catch (LimitReached endless) {
            throw PartFormat.doesNotEnd(call.name(), VolumeClipTopic.MOST_STEPS);
        }
    }

    @Override
    protected Written steps(Call<VolumeClipper> call, SegmentsInVolume input) {
        SteppedVolumeClipper stepped = call.stepped(SteppedVolumeClipper.class);
        return RecordedSteps.decidingLists(
                stepped.decisionFormula(),
                input.segments().stream().map(s -> drained(stepped, input.zmin(), s)).toList());
    }

    /** The walk, and that it was handed over, if it was. */
    private static List<PartFormat.SegmentStep> drained(
            SteppedVolumeClipper method, double zmin, double[] segment) {
        var steps = new ArrayList<PartFormat.SegmentStep>();
        VolumeWalk walk = VolumeClipTopic.walk(method, zmin, segment);
        while (walk.advance()) steps.add(step(walk.at(), walk.decision(), walk));
        if (walk.unsure()) steps.add(step("without rounding", Double.NaN, walk));
        return steps;
    }

    private static PartFormat.SegmentStep step(String at, double decision, VolumeWalk walk) {
        var left = new ArrayList<Double>();
        walk.piece((x0, y0, z0, x1, y1, z1) -> left.addAll(List.of(x0, y0, z0, x1, y1, z1)));
        return new PartFormat.SegmentStep(
                at, decision, left.stream().mapToDouble(Double::doubleValue).toArray());
    }
}
