package rasterlab.engine.light.normals;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.study.WrongLength;
import rasterlab.engine.transform.Images;

/**
 * Normals of vertices.
 *
 * <p>All methods are held against the mean by angles, the only one that does not change when flat
 * faces are cut otherwise. The error is the largest distance between the tips of two normals. Up to
 * 10⁻¹² counts as exact: a mean of many faces adds their roundings. A normal is usable within 0.02,
 * about 1°, which moves a diffuse intensity by at most 5 of 255 levels.
 */
public final class NormalsTopic implements Topic<VertexNormals, TriangleSurface, Images> {
    private static final String LEFT_OUT = "faces left out";

    private static final double CORRECT = 1e-12;
    private static final double USABLE = 0.02;

    @Override
    public String name() {
        return "vertex-normals";
    }

    @Override
    public String lab() {
        return "light";
    }

    @Override
    public Class<VertexNormals> contract() {
        return VertexNormals.class;
    }

    @Override
    public List<Method<VertexNormals>> methods() {
        return NormalsMethods.all();
    }

    @Override
    public List<Hazard<TriangleSurface>> hazards() {
        return NormalsHazards.all();
    }

    @Override
    public List<Workload<TriangleSurface>> workloads() {
        return NormalsWorkloads.all();
    }

    @Override
    public List<Mutant<VertexNormals>> mutants() {
        return NormalsMutants.of(new WeightedNormals(Weight.ANGLE));
    }

    @Override
    public List<Slip<VertexNormals>> slips(VertexNormals right) {
        return NormalsSlips.of(right);
    }

    @Override
    public List<Mutant<VertexNormals>> mutants(String method) {
        return method.equals("area")
                ? NormalsMutants.of(new WeightedNormals(Weight.AREA))
                : mutants();
    }

    @Override
    public Images run(VertexNormals method, TriangleSurface surface, int limit) {
        double[] normals = method.normals(surface.vertices(), surface.triangles());
        WrongLength.require(surface.vertices().length, normals.length, "numbers");
        return new Images(normals, 3).first(limit);
    }

    @Override
    public long spend(VertexNormals method, TriangleSurface surface) {
        return method.normals(surface.vertices(), surface.triangles()).length / 3;
    }

    @Override
    public Images exact(TriangleSurface surface, int limit) {
        return new Images(ExactNormals.of(surface), 3).first(limit);
    }

    @Override
    public Deviation compare(TriangleSurface surface, Images exact, Images actual) {
        double worst = 0;
        String first = "";
        double[] right = exact.coordinates();
        double[] is = actual.coordinates();
        for (int at = 0; at < right.length; at += 3) {
            double error = distance(right, is, at);
            if (error > worst && worst <= CORRECT)
                first =
                        "normal of vertex %d is %s, right is %s"
                                .formatted(at / 3, text(is, at), text(right, at));
            worst = Math.max(worst, error);
        }
        return new Deviation(worst, 0, 0, exact.size(), first);
    }

    private static double distance(double[] right, double[] is, int at) {
        double square = 0;
        for (int c = at; c < at + 3; c++) square += (is[c] - right[c]) * (is[c] - right[c]);
        return Double.isNaN(square) ? Double.POSITIVE_INFINITY : Math.sqrt(square);
    }

    private static String text(double[] numbers, int at) {
        return Arrays.toString(Arrays.copyOfRange(numbers, at, at + 3));
    }

    @Override
    public boolean isPromised(TriangleSurface surface) {
        return OrdinarySurface.is(surface);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= CORRECT;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE;
    }

    @Override
    public Map<String, Long> operations(VertexNormals method, TriangleSurface surface) {
        if (!(method instanceof SteppedNormals stepped)) return Map.of();
        NormalsWalk walk = stepped.walk(surface.vertices(), surface.triangles());
        long added = 0;
        while (walk.advance()) added++;
        return Map.of("normals added", added, LEFT_OUT, (long) walk.leftOut());
    }

    @Override
    public boolean isWork(String count) {
        return !count.equals(LEFT_OUT);
    }

    @Override
    public String item() {
        return "vertex";
    }

    @Override
    public String errorUnit() {
        return "of the normal's length";
    }

    @Override
    public Format<VertexNormals, TriangleSurface, Images> format() {
        return new NormalsFormat(this);
    }
}
