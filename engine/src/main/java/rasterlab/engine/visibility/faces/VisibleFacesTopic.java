package rasterlab.engine.visibility.faces;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.contract.VisibleFaces;
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
import rasterlab.engine.study.WrongLength;

/** Faces turned towards the eye, which of one convex body are those that are seen. */
public final class VisibleFacesTopic implements Topic<VisibleFaces, Body, SeenFaces> {
    @Override
    public String name() {
        return "visible-faces";
    }

    @Override
    public String lab() {
        return "visibility";
    }

    @Override
    public Class<VisibleFaces> contract() {
        return VisibleFaces.class;
    }

    @Override
    public List<Method<VisibleFaces>> methods() {
        return VisibleFacesMethods.all();
    }

    @Override
    public List<Hazard<Body>> hazards() {
        return VisibleFacesHazards.all();
    }

    @Override
    public List<Workload<Body>> workloads() {
        return VisibleFacesWorkloads.all();
    }

    @Override
    public List<Mutant<VisibleFaces>> mutants() {
        return VisibleFacesMutants.all();
    }

    @Override
    public List<Slip<VisibleFaces>> slips(VisibleFaces right) {
        return VisibleFacesSlips.of(right);
    }

    @Override
    public SeenFaces run(VisibleFaces method, Body body, int limit) {
        boolean[] visible = method.visible(body.xyz(), body.faces(), body.eye(), body.inside());
        WrongLength.require(body.faceCount(), visible.length, "faces");
        var all = new SeenFaces(visible);
        if (all.size() > limit) throw new LimitReached(limit, all.first(limit));
        return all;
    }

    @Override
    public long spend(VisibleFaces method, Body body) {
        return method.visible(body.xyz(), body.faces(), body.eye(), body.inside()).length;
    }

    @Override
    public SeenFaces exact(Body body, int limit) {
        var reference = new ExactFaces(body);
        var visible = new boolean[Math.min(limit, body.faceCount())];
        for (int f = 0; f < visible.length; f++) visible[f] = reference.visible(body.faces()[f]);
        return new SeenFaces(visible);
    }

    @Override
    public Deviation compare(Body body, SeenFaces exact, SeenFaces actual) {
        return exact.deviation(actual);
    }

    @Override
    public Map<String, Long> operations(VisibleFaces method, Body body) {
        if (!(method instanceof SteppedVisibleFaces stepped)) return Map.of();
        FaceWalk walk = stepped.walk(body);
        boolean more;
        do more = walk.advance();
        while (more);
        return walk.operations();
    }

    @Override
    public Optional<PointQuestion<Body, SeenFaces>> question() {
        return Optional.of(new FaceQuestion());
    }

    @Override
    public String item() {
        return "face";
    }

    @Override
    public String errorUnit() {
        return "% of the faces";
    }

    @Override
    public Format<VisibleFaces, Body, SeenFaces> format() {
        return new VisibleFacesFormat(this);
    }
}
