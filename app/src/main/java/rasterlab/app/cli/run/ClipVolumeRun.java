package rasterlab.app.cli.run;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.VolumeClipper;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.SegmentsInVolume;
import rasterlab.engine.clip.SteppedVolumeClipper;
import rasterlab.engine.clip.VolumeClipTopic;
import rasterlab.engine.clip.VolumeWalk;
import rasterlab.engine.study.Topic;

/** Topic {@code clip-volume}: {@code zmin}, {@code segments}; {@code segments} out. */
public final class ClipVolumeRun implements TopicRun {
    private static final JsonField<Double> ZMIN = JsonField.required("zmin", StrictJson::number);
    private static final JsonField<double[]> SEGMENTS =
            JsonField.required("segments", json -> json.points(6, 0, ClipRun.MOST));

    private final Topic<VolumeClipper, SegmentsInVolume, ClippedEnds> topic;
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    ClipVolumeRun(Watch watch) {
        this(watch, new VolumeClipTopic());
    }

    ClipVolumeRun(Watch watch, Topic<VolumeClipper, SegmentsInVolume, ClippedEnds> topic) {
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
                {"zmin":z, "segments":[[x0,y0,z0,x1,y1,z1],...]}, 0 < z < 1""",
                """
                {"segments":[...]} in their order, null where nothing is left""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        Given given = StrictJson.object(text, length, ZMIN, SEGMENTS);
        List<double[]> segments = ClipRun.rows(given.get(SEGMENTS), 6);
        SegmentsInVolume input = input(given.get(ZMIN), segments);
        VolumeClipper clipper = topic.method(method).implementation();
        if (steps) ClipRun.requireFewStepped(segments.size());
        return ClipRun.watched(
                watch,
                method,
                VolumeClipTopic.MOST_STEPS,
                () -> clipped(method, clipper, input, steps));
    }

    private Answer clipped(
            String method, VolumeClipper clipper, SegmentsInVolume input, boolean steps) {
        ClippedEnds left = topic.record(clipper, input, Integer.MAX_VALUE);
        if (!steps) return json -> ClipRun.writeParts(json, left.parts());
        SteppedVolumeClipper stepped = Steps.of(method, clipper, SteppedVolumeClipper.class);
        var walks = input.segments().stream().map(s -> steps(stepped, input.zmin(), s)).toList();
        return json -> {
            ClipRun.writeParts(json, left.parts());
            Steps.writeLists(
                    json, stepped.decisionFormula(), walks, (out, step) -> step.write(out));
        };
    }

    private static SegmentsInVolume input(double zmin, List<double[]> segments) {
        try {
            return new SegmentsInVolume(zmin, segments);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput("/zmin: " + e.getMessage());
        }
    }

    /** The walk, and that it was handed over, if it was. */
    private static List<ClipRun.Step> steps(
            SteppedVolumeClipper method, double zmin, double[] segment) {
        var steps = new ArrayList<ClipRun.Step>();
        VolumeWalk walk = VolumeClipTopic.walk(method, zmin, segment);
        while (walk.advance()) steps.add(step(walk.at(), walk.decision(), walk));
        if (walk.unsure()) steps.add(step("without rounding", Double.NaN, walk));
        return steps;
    }

    private static ClipRun.Step step(String at, double decision, VolumeWalk walk) {
        var left = new ArrayList<Double>();
        walk.piece((x0, y0, z0, x1, y1, z1) -> left.addAll(List.of(x0, y0, z0, x1, y1, z1)));
        return new ClipRun.Step(
                at, decision, left.stream().mapToDouble(Double::doubleValue).toArray());
    }
}
