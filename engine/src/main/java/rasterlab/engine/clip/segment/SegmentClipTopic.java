package rasterlab.engine.clip.segment;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;
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
 * Clipping segments by an upright rectangle.
 *
 * <p>Right means: no segment misjudged, and every new end within 10⁻¹² of {@link ClipWindow#unit}
 * of the exact one. No method in doubles can do without that tolerance, since exact ends are
 * fractions; the bound is that of {@link RoundingBound}. Usable means: none misjudged, ends within
 * a thousandth of the window, about a pixel.
 */
public final class SegmentClipTopic
        implements Topic<SegmentClipper, SegmentsInWindow, ClippedEnds> {
    static final double RIGHT_UNITS = 1e-12;
    static final double USABLE_UNITS = 1e-3;

    /** More steps than any method that ends makes for one segment. */
    public static final int MOST_STEPS = 1_000;

    @Override
    public String name() {
        return "clip-segment";
    }

    @Override
    public String lab() {
        return "clip";
    }

    @Override
    public Class<SegmentClipper> contract() {
        return SegmentClipper.class;
    }

    @Override
    public List<Method<SegmentClipper>> methods() {
        return SegmentClipMethods.all();
    }

    @Override
    public List<Hazard<SegmentsInWindow>> hazards() {
        return SegmentClipHazards.all();
    }

    @Override
    public List<Workload<SegmentsInWindow>> workloads() {
        return SegmentClipWorkloads.all();
    }

    @Override
    public List<Mutant<SegmentClipper>> mutants() {
        return SegmentClipMutants.all();
    }

    @Override
    public List<Slip<SegmentClipper>> slips(SegmentClipper right) {
        return SegmentClipSlips.of(right);
    }

    /**
     * {@inheritDoc}
     *
     * @throws LimitReached also when a stepped method makes more than {@value #MOST_STEPS} steps
     *     for one segment
     */
    @Override
    public ClippedEnds run(SegmentClipper method, SegmentsInWindow input, int limit) {
        var capture = new PartCapture(limit);
        for (double[] s : input.segments()) {
            if (method instanceof SteppedSegmentClipper stepped)
                drained(walk(stepped, input.window(), s), capture).send(capture);
            else clip(method, input.window(), s, capture);
            capture.next();
        }
        return capture.captured();
    }

    private static SegmentWalk drained(SegmentWalk walk, PartCapture capture) {
        for (int steps = 0; walk.advance(); steps++)
            if (steps == MOST_STEPS) throw new LimitReached(MOST_STEPS, capture.captured());
        return walk;
    }

    /** Has a method clip one segment, given by the coordinates of its ends. */
    public static void clip(SegmentClipper method, ClipWindow window, double[] s, SegmentSink out) {
        method.clip(
                window.xmin(),
                window.ymin(),
                window.xmax(),
                window.ymax(),
                s[0],
                s[1],
                s[2],
                s[3],
                out);
    }

    /** The walk of one segment, given as x0, y0, x1, y1. */
    public static SegmentWalk walk(SteppedSegmentClipper method, ClipWindow window, double[] s) {
        return method.walk(
                window.xmin(), window.ymin(), window.xmax(), window.ymax(), s[0], s[1], s[2], s[3]);
    }

    @Override
    public long spend(SegmentClipper method, SegmentsInWindow input) {
        var sum = new EndSum();
        for (double[] s : input.segments()) clip(method, input.window(), s, sum);
        sum.requireComputed();
        return input.segments().size();
    }

    @Override
    public ClippedEnds exact(SegmentsInWindow input, int limit) {
        double[] sides = input.window().sides();
        return new ClippedEnds(
                input.segments().stream()
                        .limit(limit)
                        .map(ends -> ExactClip.plane(sides, ends))
                        .toList(),
                0);
    }

    @Override
    public Deviation compare(SegmentsInWindow input, ClippedEnds exact, ClippedEnds actual) {
        ClipWindow window = input.window();
        return EndComparison.compare(
                exact,
                actual,
                window.unit(),
                input.segments(),
                point -> window.code(point[0], point[1]) == 0);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return EndComparison.within(RIGHT_UNITS, deviation);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return EndComparison.within(USABLE_UNITS, deviation);
    }

    @Override
    public Map<String, Long> operations(SegmentClipper method, SegmentsInWindow input) {
        var counts = new TreeMap<String, Long>();
        if (!(method instanceof SteppedSegmentClipper stepped)) return counts;
        for (double[] s : input.segments()) {
            SegmentWalk walk = walk(stepped, input.window(), s);
            long steps = 0;
            while (walk.advance()) steps++;
            counts.merge("steps", steps, Long::sum);
            counts.merge("divisions", (long) walk.divisions(), Long::sum);
            counts.merge("handed over", walk.unsure() ? 1L : 0L, Long::sum);
        }
        return counts;
    }

    @Override
    public Optional<PointQuestion<SegmentsInWindow, ClippedEnds>> question() {
        return Optional.of(new SegmentQuestion());
    }

    @Override
    public String item() {
        return "segment";
    }

    /** {@inheritDoc} It is how many of a hundred segments are visible. */
    @Override
    public boolean sized() {
        return false;
    }

    @Override
    public String errorUnit() {
        return "window sizes";
    }

    @Override
    public Format<SegmentClipper, SegmentsInWindow, ClippedEnds> format() {
        return new SegmentClipFormat(this);
    }
}
