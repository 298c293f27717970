package rasterlab.engine.spline.curve;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.exact.CurveComparison;
import rasterlab.engine.spline.exact.CurveSlips;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.DenseCurve;
import rasterlab.engine.spline.exact.ExactCurve;
import rasterlab.engine.spline.exact.Polyline;
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
 * Computing points of a curve, and drawing it by a polyline.
 *
 * <p>The error is a multiple of what {@link CurveComparison} allows, so that up to 1 all is well;
 * the last digits of the reference's own doubles are let pass.
 */
public final class CurveTopic implements Topic<CurveTracer, CurveTask, Polyline> {
    private static final double ALLOWED = 1 + 1e-9;
    private static final double USABLE = 4;

    /** Chords of the reference for each that the control polygon's length could ask for. */
    private static final int DENSER = 16;

    private static final String SEGMENTS = "segments";
    private static final int FEWEST = 256;
    private static final int MOST = 16_000;

    @Override
    public String name() {
        return "curve";
    }

    @Override
    public String lab() {
        return "spline";
    }

    @Override
    public Class<CurveTracer> contract() {
        return CurveTracer.class;
    }

    @Override
    public List<Method<CurveTracer>> methods() {
        return CurveMethods.all();
    }

    @Override
    public List<Hazard<CurveTask>> hazards() {
        return CurveHazards.all();
    }

    @Override
    public List<Workload<CurveTask>> workloads() {
        return CurveWorkloads.all();
    }

    @Override
    public List<Mutant<CurveTracer>> mutants() {
        return CurveMutants.all();
    }

    @Override
    public List<Slip<CurveTracer>> slips(CurveTracer right) {
        return CurveSlips.of(right);
    }

    @Override
    public Polyline run(CurveTracer method, CurveTask task, int limit) {
        var polyline = new Polyline(limit);
        run(method, task, polyline);
        return polyline;
    }

    private static void run(CurveTracer method, CurveTask task, CurvePoints out) {
        if (task.flatness() > 0) method.flatten(task.curve(), task.flatness(), out);
        else method.at(task.curve(), task.at(), out);
    }

    @Override
    public long spend(CurveTracer method, CurveTask task) {
        var counting = new CountingPoints(limit(task));
        run(method, task, counting);
        return counting.count();
    }

    private static long limit(CurveTask task) {
        return task.flatness() > 0 ? Flatness.MOST_SEGMENTS * 2L : task.at().length;
    }

    /** Counts points and adds up their places, so that a compiler cannot leave them uncomputed. */
    private static final class CountingPoints implements CurvePoints {
        private final long limit;
        private long count;
        private double places;

        CountingPoints(long limit) {
            this.limit = limit;
        }

        @Override
        public void point(double x, double y) {
            if (count == limit) throw new LimitReached((int) limit, null);
            count++;
            places += x + y;
        }

        long count() {
            if (Double.isNaN(places)) throw new AssertionError("a point is not a number");
            return count;
        }
    }

    @Override
    public Polyline exact(CurveTask task, int limit) {
        if (task.flatness() > 0) return dense(task, limit);
        var exact = new ExactCurve(task.curve());
        var points = new Polyline(limit);
        for (int i = 0; i < Math.min(limit, task.at().length); i++)
            points.point(exact.x(task.at()[i]), exact.y(task.at()[i]));
        return points;
    }

    private static Polyline dense(CurveTask task, int limit) {
        Curve curve = task.curve();
        double length = 0;
        for (int i = 1; i < curve.x().length; i++)
            length += Math.hypot(curve.x()[i] - curve.x()[i - 1], curve.y()[i] - curve.y()[i - 1]);
        double chords = curve.degree() * Math.sqrt(curve.spans() * length / (4 * task.flatness()));
        long most = Math.min(MOST, limit - curve.spans());
        long wanted = Math.max(FEWEST, Math.min(most, (long) (DENSER * chords)));
        return new DenseCurve(task.curve()).sampled((int) wanted);
    }

    @Override
    public Deviation compare(CurveTask task, Polyline exact, Polyline actual) {
        return CurveComparison.compare(task, exact, actual);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return within(ALLOWED, deviation);
    }

    /** Whether the curve is off by up to four times what is allowed: seen by who looks for it. */
    @Override
    public boolean usable(Deviation deviation) {
        return within(USABLE, deviation);
    }

    private static boolean within(double multiple, Deviation deviation) {
        return deviation.worst() <= multiple && deviation.missing() + deviation.extra() == 0;
    }

    /**
     * The operations that the walk counts; none for a student's method and for points at given t.
     */
    @Override
    public Map<String, Long> operations(CurveTracer method, CurveTask task) {
        if (!(method instanceof SteppedCurve stepped) || task.flatness() == 0) return Map.of();
        CurveWalk walk = stepped.walk(task.curve(), task.flatness());
        long points = 0;
        while (walk.advance()) points++;
        return Map.of(SEGMENTS, points - 1, "splits", walk.splits());
    }

    /** {@inheritDoc} Fewer points for the same curve are the better answer. */
    @Override
    public String countedPer() {
        return "curve";
    }

    @Override
    public Optional<String> parts() {
        return Optional.of(SEGMENTS);
    }

    /**
     * {@inheritDoc} A curve that the reference does not follow closely enough has as many points as
     * its flatness asks for.
     */
    @Override
    public long mostBeforeEndless(long exactItems) {
        return exactItems > MOST
                ? Flatness.MOST_SEGMENTS + 1L
                : Topic.super.mostBeforeEndless(exactItems);
    }

    @Override
    public String item() {
        return "point";
    }

    @Override
    public String errorUnit() {
        return "times what is allowed";
    }

    @Override
    public Format<CurveTracer, CurveTask, Polyline> format() {
        return new CurveFormat(this);
    }
}
