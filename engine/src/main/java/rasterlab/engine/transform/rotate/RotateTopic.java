package rasterlab.engine.transform.rotate;

import java.math.BigDecimal;
import java.util.List;
import java.util.Map;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.exact.BigTrig;

/**
 * Turning points about the origin.
 *
 * <p>The error is the largest difference of a coordinate over the point's larger coordinate. Up to
 * 16·2⁻⁵³ counts as exact: one turn rounds sine, cosine, two products and a sum. An output is
 * usable within 0.01, a pixel in a picture with a radius of 100.
 */
public final class RotateTopic implements Topic<PlaneRotation, Turns, Images> {
    private static final double CORRECT = 16 * 0x1p-53;
    private static final double USABLE = 0.01;

    @Override
    public String name() {
        return "rotate";
    }

    @Override
    public String lab() {
        return "coordinates";
    }

    @Override
    public Class<PlaneRotation> contract() {
        return PlaneRotation.class;
    }

    @Override
    public List<Method<PlaneRotation>> methods() {
        return RotateMethods.all();
    }

    @Override
    public List<Hazard<Turns>> hazards() {
        return RotateHazards.all();
    }

    @Override
    public List<Workload<Turns>> workloads() {
        return RotateWorkloads.all();
    }

    @Override
    public List<Mutant<PlaneRotation>> mutants() {
        return RotateMutants.all();
    }

    @Override
    public List<Slip<PlaneRotation>> slips(PlaneRotation right) {
        return RotateSlips.of(right);
    }

    @Override
    public Images run(PlaneRotation method, Turns turns, int limit) {
        double[] points = turns.points().clone();
        method.rotate(turns.degrees(), turns.times(), points);
        return new Images(points, 2).first(limit);
    }

    /** The number of points times that of turns. */
    @Override
    public long spend(PlaneRotation method, Turns turns) {
        double[] points = turns.points().clone();
        method.rotate(turns.degrees(), turns.times(), points);
        return points.length / 2L * turns.times();
    }

    @Override
    public Images exact(Turns turns, int limit) {
        BigTrig total =
                BigTrig.ofDegrees(
                        new BigDecimal(turns.degrees())
                                .multiply(BigDecimal.valueOf(turns.times())));
        BigDecimal sin = total.sin();
        BigDecimal cos = total.cos();
        double[] p = new Images(turns.points(), 2).first(limit).coordinates();
        var images = new double[p.length];
        for (int at = 0; at < p.length; at += 2) {
            var x = new BigDecimal(p[at]);
            var y = new BigDecimal(p[at + 1]);
            images[at] = x.multiply(cos).subtract(y.multiply(sin)).doubleValue();
            images[at + 1] = x.multiply(sin).add(y.multiply(cos)).doubleValue();
        }
        return new Images(images, 2);
    }

    @Override
    public Deviation compare(Turns turns, Images exact, Images actual) {
        var scales = new double[exact.size()];
        double[] p = turns.points();
        for (int i = 0; i < scales.length; i++)
            scales[i] =
                    Math.max(
                            Double.MIN_NORMAL,
                            Math.max(Math.abs(p[2 * i]), Math.abs(p[2 * i + 1])));
        return exact.deviation(actual, scales);
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
    public Map<String, Long> operations(PlaneRotation method, Turns turns) {
        if (!(method instanceof CountedRotation counted)) return Map.of();
        var counting = new CountingTurnLoops();
        counted.rotate(counting, turns.degrees(), turns.times(), turns.points().clone());
        return counting.counts();
    }

    @Override
    public String item() {
        return "turn of a point";
    }

    @Override
    public String errorUnit() {
        return "of the point's larger coordinate";
    }

    @Override
    public Format<PlaneRotation, Turns, Images> format() {
        return new RotateFormat(this);
    }
}
