package rasterlab.engine.polygon.triangle;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.polygon.ExactMembership;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.MembershipComparison;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
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
 * Whether points lie in a triangle.
 *
 * <p>Answers are yes or no, so exact means all right. Degraded is a method that errs only on points
 * within {@value #USABLE_ULPS} ulps of the boundary, which a picture cannot show.
 */
public final class PointInTriangleTopic
        implements Topic<PointInTriangle, ShapeAndPoints, Membership> {
    private static final double USABLE_ULPS = 4;

    @Override
    public String name() {
        return "point-in-triangle";
    }

    @Override
    public String lab() {
        return "polygon";
    }

    @Override
    public Class<PointInTriangle> contract() {
        return PointInTriangle.class;
    }

    @Override
    public List<Method<PointInTriangle>> methods() {
        return TriangleMethods.all();
    }

    @Override
    public List<Hazard<ShapeAndPoints>> hazards() {
        return TriangleHazards.all();
    }

    @Override
    public List<Workload<ShapeAndPoints>> workloads() {
        return TriangleWorkloads.all();
    }

    @Override
    public List<Mutant<PointInTriangle>> mutants() {
        return PointInTriangleMutants.all();
    }

    @Override
    public List<Slip<PointInTriangle>> slips(PointInTriangle right) {
        return PointInTriangleSlips.of(right);
    }

    @Override
    public Membership run(PointInTriangle method, ShapeAndPoints input, int limit) {
        Points t = input.corners();
        var answer =
                new Membership(
                        input.points(),
                        limit,
                        (x, y) ->
                                method.contains(
                                        t.x(0), t.y(0), t.x(1), t.y(1), t.x(2), t.y(2), x, y));
        if (input.points().size() > limit) throw new LimitReached(limit, answer);
        return answer;
    }

    @Override
    public long spend(PointInTriangle method, ShapeAndPoints input) {
        Points t = input.corners();
        double ax = t.x(0);
        double ay = t.y(0);
        double bx = t.x(1);
        double by = t.y(1);
        double cx = t.x(2);
        double cy = t.y(2);
        Points points = input.points();
        long outside = 0;
        for (int i = 0; i < points.size(); i++)
            if (!method.contains(ax, ay, bx, by, cx, cy, points.x(i), points.y(i))) outside++;
        // Never true, but only this class knows: the answers have to be computed.
        if (outside > points.size()) throw new AssertionError("more outside than points");
        return points.size();
    }

    @Override
    public Membership exact(ShapeAndPoints input, int limit) {
        return new Membership(input.points(), limit, new ExactMembership(input.corners()));
    }

    @Override
    public Deviation compare(ShapeAndPoints input, Membership exact, Membership actual) {
        return MembershipComparison.compare(input, exact, actual);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE_ULPS;
    }

    @Override
    public Map<String, Long> operations(PointInTriangle method, ShapeAndPoints input) {
        if (method instanceof RobustTriangle) return ofRobust(input);
        return method instanceof SteppedTriangleTest stepped ? walked(stepped, input) : Map.of();
    }

    /** The counts of the walks. */
    private static Map<String, Long> walked(SteppedTriangleTest method, ShapeAndPoints input) {
        var counts = new TreeMap<String, Long>();
        Points t = input.corners();
        for (int i = 0; i < input.points().size(); i++) {
            double x = input.points().x(i);
            double y = input.points().y(i);
            SideWalk walk = method.walk(t.x(0), t.y(0), t.x(1), t.y(1), t.x(2), t.y(2), x, y);
            walk.drain();
            walk.operations().forEach((name, more) -> counts.merge(name, more, Long::sum));
        }
        return counts;
    }

    /**
     * The operations of the robust method, which before the exact sides does the same for every
     * point.
     */
    private Map<String, Long> ofRobust(ShapeAndPoints input) {
        var exactSides = new long[1];
        long points = spend(new RobustTriangle(() -> exactSides[0]++), input);
        return Map.of(
                "sides asked", 3 * points,
                "sides asked exactly", exactSides[0],
                "multiplications", RobustTriangle.MULTIPLICATIONS * points,
                "additions", RobustTriangle.ADDITIONS * points);
    }

    @Override
    public Optional<PointQuestion<ShapeAndPoints, Membership>> question() {
        return Optional.of(new TriangleQuestion());
    }

    @Override
    public String item() {
        return "point";
    }

    @Override
    public String errorUnit() {
        return "ulps";
    }

    @Override
    public Format<PointInTriangle, ShapeAndPoints, Membership> format() {
        return new TriangleFormat(this);
    }
}
