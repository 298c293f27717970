package rasterlab.engine.clip.volume;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import rasterlab.contract.SpaceSegmentSink;
import rasterlab.contract.VolumeClipper;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.EndComparison;
import rasterlab.engine.clip.EndSum;
import rasterlab.engine.clip.PartCapture;
import rasterlab.engine.clip.exact.ExactClip;
import rasterlab.engine.predicate.PointQuestion;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Clipping segments by the normalised view volume.
 *
 * <p>Right means: no segment misjudged, and every new end within 10⁻¹² of the exact one, the
 * volume's depth being 1; ends are fractions, which no double is equal to. Usable means: none
 * misjudged, ends within a thousandth.
 */
public final class VolumeClipTopic implements Topic<VolumeClipper, SegmentsInVolume, ClippedEnds> {
    static final double RIGHT = 1e-12;
    private static final double USABLE = 1e-3;
    public static final int MOST_STEPS = 1_000;

    @Override
    public String name() {
        return "clip-volume";
    }

    @Override
    public String lab() {
        return "clip";
    }

    @Override
    public Class<VolumeClipper> contract() {
        return VolumeClipper.class;
    }

    @Override
    public List<Method<VolumeClipper>> methods() {
        return List.of(
                Method.right("cohen-sutherland-6", new CohenSutherland6()),
                Method.failing("divide-first-textbook", new DivideFirstTextbook()),
                Method.right("homogeneous", new HomogeneousClip()));
    }

    @Override
    public List<Hazard<SegmentsInVolume>> hazards() {
        return VolumeClipHazards.all();
    }

    @Override
    public List<Workload<SegmentsInVolume>> workloads() {
        return VolumeClipWorkloads.all();
    }

    @Override
    public List<Mutant<VolumeClipper>> mutants() {
        return VolumeClipMutants.all();
    }

    @Override
    public List<Slip<VolumeClipper>> slips(VolumeClipper right) {
        return VolumeClipSlips.of(right);
    }

    /**
     * {@inheritDoc}
     *
     * @throws LimitReached also when a stepped method makes more than {@value #MOST_STEPS} steps
     *     for one segment
     */
    @Override
    public ClippedEnds run(VolumeClipper method, SegmentsInVolume input, int limit) {
        var capture = new PartCapture(limit);
        for (double[] s : input.segments()) {
            if (method instanceof SteppedVolumeClipper stepped)
                drained(walk(stepped, input.zmin(), s), capture).send(capture);
            else clip(method, input.zmin(), s, capture);
            capture.next();
        }
        return capture.captured();
    }

    private static VolumeWalk drained(VolumeWalk walk, PartCapture capture) {
        for (int steps = 0; walk.advance(); steps++)
            if (steps == MOST_STEPS) throw new LimitReached(MOST_STEPS, capture.captured());
        return walk;
    }

    /** Has a method clip one segment, given by the coordinates of its ends. */
    public static void clip(VolumeClipper method, double zmin, double[] s, SpaceSegmentSink out) {
        method.clip(zmin, s[0], s[1], s[2], s[3], s[4], s[5], out);
    }

    /** The walk of one segment, given as x0, y0, z0, x1, y1, z1. */
    public static VolumeWalk walk(SteppedVolumeClipper method, double zmin, double[] s) {
        return method.walk(zmin, s[0], s[1], s[2], s[3], s[4], s[5]);
    }

    @Override
    public long spend(VolumeClipper method, SegmentsInVolume input) {
        var sum = new EndSum();
        for (double[] s : input.segments()) clip(method, input.zmin(), s, sum);
        sum.requireComputed();
        return input.segments().size();
    }

    @Override
    public ClippedEnds exact(SegmentsInVolume input, int limit) {
        return new ClippedEnds(
                input.segments().stream()
                        .limit(limit)
                        .map(ends -> ExactClip.volume(input.zmin(), ends))
                        .toList(),
                0);
    }

    @Override
    public Deviation compare(SegmentsInVolume input, ClippedEnds exact, ClippedEnds actual) {
        return EndComparison.compare(
                exact, actual, 1, input.segments(), point -> isInside(input.zmin(), point));
    }

    private static boolean isInside(double zmin, double[] p) {
        return Math.abs(p[0]) <= p[2] && Math.abs(p[1]) <= p[2] && p[2] >= zmin && p[2] <= 1;
    }

    @Override
    public boolean correct(Deviation deviation) {
        return EndComparison.within(RIGHT, deviation);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return EndComparison.within(USABLE, deviation);
    }

    @Override
    public Map<String, Long> operations(VolumeClipper method, SegmentsInVolume input) {
        var counts = new TreeMap<String, Long>();
        if (!(method instanceof SteppedVolumeClipper stepped)) return counts;
        for (double[] s : input.segments()) {
            VolumeWalk walk = walk(stepped, input.zmin(), s);
            long steps = 0;
            while (walk.advance()) steps++;
            walk.send(new PartCapture(1));
            counts.merge("steps", steps, Long::sum);
            counts.merge("divisions", (long) walk.divisions(), Long::sum);
            counts.merge("handed over", walk.unsure() ? 1L : 0L, Long::sum);
        }
        return counts;
    }

    @Override
    public Optional<PointQuestion<SegmentsInVolume, ClippedEnds>> question() {
        return Optional.of(new VolumeQuestion());
    }

    @Override
    public String item() {
        return "segment";
    }

    @Override
    public String errorUnit() {
        return "volume depths";
    }

    @Override
    public Format<VolumeClipper, SegmentsInVolume, ClippedEnds> format() {
        return new VolumeClipFormat(this);
    }
}
