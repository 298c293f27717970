package rasterlab.engine.polygon.triangulation;

import java.util.List;
import java.util.Map;
import rasterlab.contract.Triangulator;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/** Cutting a polygon into triangles; right is whatever covers it once and nothing else. */
public final class TriangulateTopic implements Topic<Triangulator, Points, Triangles> {
    private static final int MOST_ITEMS = 1_000_000;

    @Override
    public String name() {
        return "triangulate";
    }

    @Override
    public String lab() {
        return "polygon";
    }

    @Override
    public Class<Triangulator> contract() {
        return Triangulator.class;
    }

    @Override
    public List<Method<Triangulator>> methods() {
        return TriangulateMethods.all();
    }

    @Override
    public List<Hazard<Points>> hazards() {
        return TriangulateHazards.all();
    }

    @Override
    public List<Workload<Points>> workloads() {
        return TriangulateWorkloads.all();
    }

    @Override
    public List<Mutant<Triangulator>> mutants() {
        return TriangulateMutants.all();
    }

    @Override
    public List<Slip<Triangulator>> slips(Triangulator right) {
        return TriangulateSlips.of(right);
    }

    @Override
    public Triangles run(Triangulator method, Points corners, int limit) {
        var answer = new Triangles(method.triangulate(corners.x(), corners.y()));
        if (answer.size() > limit) throw new LimitReached(limit, answer.first(limit));
        return answer;
    }

    @Override
    public long spend(Triangulator method, Points corners) {
        return method.triangulate(corners.x(), corners.y()).length / 3;
    }

    /**
     * {@inheritDoc}
     *
     * @return one of the right answers; none where the polygon is not simple
     */
    @Override
    public Triangles exact(Points corners, int limit) {
        return new ExactTriangulation(corners).cut().first(limit);
    }

    @Override
    public Deviation compare(Points corners, Triangles exact, Triangles actual) {
        return TriangulationComparison.compare(corners, exact, actual);
    }

    /** The turns of three corners that each method computes, counted as they are made. */
    @Override
    public Map<String, Long> operations(Triangulator method, Points corners) {
        if (!(method instanceof SteppedTriangulator stepped)) return Map.of();
        TriangleWalk walk = stepped.walk(corners.xs(), corners.ys());
        long cuts = 0;
        while (walk.advance()) cuts++;
        return Map.of("cuts", cuts, "turns", walk.turns());
    }

    /** {@inheritDoc} Methods answer in different orders, so no answer is cut. */
    @Override
    public int mostItems() {
        return MOST_ITEMS;
    }

    @Override
    public String item() {
        return "triangle";
    }

    @Override
    public String errorUnit() {
        return "% of the area";
    }

    @Override
    public Format<Triangulator, Points, Triangles> format() {
        return new TriangulateFormat(this);
    }
}
