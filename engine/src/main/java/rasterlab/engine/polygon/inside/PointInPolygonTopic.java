package rasterlab.engine.polygon.inside;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.contract.PointInPolygon;
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
 * Whether points lie in a polygon.
 *
 * <p>Answers are yes or no, so exact means all right. Degraded is a method that errs only on points
 * within {@value #USABLE_ULPS} ulps of the boundary, which a picture cannot show.
 */
public final class PointInPolygonTopic
        implements Topic<PointInPolygon, ShapeAndPoints, Membership> {
    private static final double USABLE_ULPS = 4;

    @Override
    public String name() {
        return "point-in-polygon";
    }

    @Override
    public String lab() {
        return "polygon";
    }

    @Override
    public Class<PointInPolygon> contract() {
        return PointInPolygon.class;
    }

    @Override
    public List<Method<PointInPolygon>> methods() {
        return InsideMethods.all();
    }

    @Override
    public List<Hazard<ShapeAndPoints>> hazards() {
        return InsideHazards.all();
    }

    @Override
    public List<Workload<ShapeAndPoints>> workloads() {
        return InsideWorkloads.all();
    }

    @Override
    public List<Mutant<PointInPolygon>> mutants() {
        return PointInPolygonMutants.all();
    }

    @Override
    public List<Slip<PointInPolygon>> slips(PointInPolygon right) {
        return PointInPolygonSlips.of(right);
    }

    @Override
    public Membership run(PointInPolygon method, ShapeAndPoints input, int limit) {
        double[] polygonX = input.corners().x();
        double[] polygonY = input.corners().y();
        var answer =
                new Membership(
                        input.points(), limit, (x, y) -> method.contains(polygonX, polygonY, x, y));
        if (input.points().size() > limit) throw new LimitReached(limit, answer);
        return answer;
    }

    @Override
    public long spend(PointInPolygon method, ShapeAndPoints input) {
        double[] polygonX = input.corners().x();
        double[] polygonY = input.corners().y();
        Points points = input.points();
        long outside = 0;
        for (int i = 0; i < points.size(); i++)
            if (!method.contains(polygonX, polygonY, points.x(i), points.y(i))) outside++;
        // Never true, but the compiler cannot know: it must compute the answers.
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

    /** The edges looked at, and those whose crossing was counted, as each walk goes. */
    @Override
    public Map<String, Long> operations(PointInPolygon method, ShapeAndPoints input) {
        if (!(method instanceof SteppedPolygonTest stepped)) return Map.of();
        long edges = 0;
        long counted = 0;
        double[] polygonX = input.corners().xs();
        double[] polygonY = input.corners().ys();
        Points points = input.points();
        for (int i = 0; i < points.size(); i++) {
            EdgeWalk walk = stepped.walk(polygonX, polygonY, points.x(i), points.y(i));
            for (int before = 0; walk.advance(); before = walk.count()) {
                edges++;
                if (walk.count() != before) counted++;
            }
        }
        return Map.of("edges", edges, "crossings", counted);
    }

    @Override
    public Optional<PointQuestion<ShapeAndPoints, Membership>> question() {
        return Optional.of(new PolygonQuestion());
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
    public Format<PointInPolygon, ShapeAndPoints, Membership> format() {
        return new PolygonTestFormat(this);
    }
}
