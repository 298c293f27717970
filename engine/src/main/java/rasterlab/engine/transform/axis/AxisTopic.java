package rasterlab.engine.transform.axis;

import java.math.BigDecimal;
import java.util.List;
import java.util.Map;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.transform.CountingArithmetic;
import rasterlab.engine.transform.Images;
import rasterlab.engine.transform.exact.BigAxis;

/**
 * Turning points about a line.
 *
 * <p>The error is the largest difference of a coordinate, over the largest coordinate of the point
 * and of the line's. Up to 32·2⁻⁵³ counts as exact: the seven steps round 17 times on the way, and
 * sine, cosine and the unit vector are rounded themselves.
 */
public final class AxisTopic implements Topic<AxisRotation, AxisTurn, Images> {
    private static final double CORRECT = 32 * 0x1p-53;
    private static final double USABLE = 1e-6;

    @Override
    public String name() {
        return "rotate-axis";
    }

    @Override
    public String lab() {
        return "coordinates";
    }

    @Override
    public Class<AxisRotation> contract() {
        return AxisRotation.class;
    }

    @Override
    public List<Method<AxisRotation>> methods() {
        return AxisMethods.all();
    }

    @Override
    public List<Hazard<AxisTurn>> hazards() {
        return AxisHazards.all();
    }

    @Override
    public List<Workload<AxisTurn>> workloads() {
        return AxisWorkloads.all();
    }

    @Override
    public List<Mutant<AxisRotation>> mutants() {
        return AxisMutants.all();
    }

    @Override
    public List<Slip<AxisRotation>> slips(AxisRotation right) {
        return AxisSlips.of(right);
    }

    @Override
    public Images run(AxisRotation method, AxisTurn turn, int limit) {
        double[] points = turn.points().clone();
        method.rotate(turn.through(), turn.direction(), turn.degrees(), points);
        return new Images(points, 3).first(limit);
    }

    @Override
    public long spend(AxisRotation method, AxisTurn turn) {
        double[] points = turn.points().clone();
        method.rotate(turn.through(), turn.direction(), turn.degrees(), points);
        return points.length / 3;
    }

    @Override
    public Images exact(AxisTurn turn, int limit) {
        var axis = new BigAxis(turn.through(), turn.direction(), turn.degrees());
        double[] p = new Images(turn.points(), 3).first(limit).coordinates();
        var images = new double[p.length];
        for (int at = 0; at < p.length; at += 3) {
            BigDecimal[] point = {
                new BigDecimal(p[at]), new BigDecimal(p[at + 1]), new BigDecimal(p[at + 2])
            };
            BigDecimal[] image = axis.image(point);
            for (int i = 0; i < 3; i++) images[at + i] = image[i].doubleValue();
        }
        return new Images(images, 3);
    }

    @Override
    public Deviation compare(AxisTurn turn, Images exact, Images actual) {
        var scales = new double[exact.size()];
        for (int i = 0; i < scales.length; i++) scales[i] = scale(turn, i);
        return exact.deviation(actual, scales);
    }

    private static double scale(AxisTurn turn, int point) {
        double largest = Double.MIN_NORMAL;
        for (int i = 0; i < 3; i++) {
            largest = Math.max(largest, Math.abs(turn.through()[i]));
            largest = Math.max(largest, Math.abs(turn.points()[3 * point + i]));
        }
        return largest;
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
    public Map<String, Long> operations(AxisRotation method, AxisTurn turn) {
        if (!(method instanceof CheckedAxisRotation counted)) return Map.of();
        var counting = new CountingArithmetic();
        counted.count(
                counting, turn.through(), turn.direction(), turn.degrees(), turn.points().clone());
        return counting.counts();
    }

    @Override
    public String item() {
        return "point";
    }

    @Override
    public String errorUnit() {
        return "of the largest coordinate";
    }

    @Override
    public Format<AxisRotation, AxisTurn, Images> format() {
        return new AxisFormat(this);
    }
}
