package rasterlab.engine.transform.view;

import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import rasterlab.contract.EyeView;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.Workload;
import rasterlab.engine.transform.CountingArithmetic;
import rasterlab.engine.transform.Images;

/**
 * The view by spherical coordinates, to compare what ways of computing it cost.
 *
 * <p>The error is the largest difference of a coordinate over the largest coordinate and ρ; up to
 * 16·2⁻⁵³ counts as exact: seven operations and two sines are rounded.
 */
public final class ViewTopic implements Topic<EyeView, ViewTask, Images> {
    private static final double CORRECT = 16 * 0x1p-53;
    private static final long SEED = 400;
    private static final List<Method<EyeView>> METHODS =
            List.of(
                    Method.right("one-matrix", new OneMatrixView()),
                    Method.right("taken-apart", new DecomposedView()),
                    Method.failing("taken-apart-textbook", new DecomposedTextbookView()));

    @Override
    public String name() {
        return "view";
    }

    @Override
    public String lab() {
        return "coordinates";
    }

    @Override
    public Class<EyeView> contract() {
        return EyeView.class;
    }

    @Override
    public List<Method<EyeView>> methods() {
        return METHODS;
    }

    @Override
    public List<Hazard<ViewTask>> hazards() {
        return List.of(
                hazard(WRONG, "pole", 30, 0, 10, 1, 2, 3),
                hazard(EXACT, "origin", 30, 60, 400, 0, 0, 0),
                hazard(WRONG, "upwards", 30, 60, 9, 0, 0, 2),
                hazard(EXACT, "to-the-right", 0, 90, 9, 0, 2, 0),
                hazard(WRONG, "quarter-turn", 90, 90, 9, 1, 2, 3),
                hazard(WRONG, "from-below", 0, 120, 9, 1, 2, 3),
                hazard(WRONG, "at-the-eye", 0, 90, 5, 5, 0, 0),
                hazard(WRONG, "far-eye", 20, 70, 1e12, 1, 2, 3));
    }

    /**
     * @param textbook what the steps as they are printed make of it
     */
    private static Hazard<ViewTask> hazard(
            Verdict.Kind textbook,
            String name,
            double theta,
            double phi,
            double rho,
            double... points) {
        return Hazard.allExactBut(
                Map.of("taken-apart-textbook", textbook),
                METHODS,
                name,
                new ViewTask(theta, phi, rho, points));
    }

    @Override
    public List<Workload<ViewTask>> workloads() {
        return List.of(points(1), points(16), points(256), points(4_096));
    }

    @Override
    public List<Mutant<EyeView>> mutants() {
        return ViewMutants.all();
    }

    @Override
    public List<Slip<EyeView>> slips(EyeView right) {
        return ViewSlips.of(right);
    }

    private static Workload<ViewTask> points(int count) {
        var random = new Random(SEED + count);
        var looks = new ArrayList<ViewTask>();
        for (int i = 0; i < 4_096 / Math.max(count, 64); i++)
            looks.add(
                    new ViewTask(
                            random.nextDouble(-180, 180),
                            random.nextDouble(0, 180),
                            random.nextDouble(200, 900),
                            random.doubles(3L * count, -100, 100).toArray()));
        return new Workload<>("points-" + count, count, looks);
    }

    @Override
    public Images run(EyeView method, ViewTask look, int limit) {
        double[] points = look.points().clone();
        method.view(look.theta(), look.phi(), look.rho(), points);
        return new Images(points, 3).first(limit);
    }

    @Override
    public long spend(EyeView method, ViewTask look) {
        return run(method, look, Integer.MAX_VALUE).size();
    }

    @Override
    public Images exact(ViewTask look, int limit) {
        return ExactView.images(look, limit);
    }

    @Override
    public Deviation compare(ViewTask look, Images exact, Images actual) {
        var scales = new double[exact.size()];
        for (int i = 0; i < scales.length; i++) {
            // Below the normal numbers rounding does not shrink with what is rounded.
            scales[i] = Math.max(look.rho(), Double.MIN_NORMAL);
            for (int j = 0; j < 3; j++)
                scales[i] = Math.max(scales[i], Math.abs(look.points()[3 * i + j]));
        }
        return exact.deviation(actual, scales);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= CORRECT;
    }

    @Override
    public Map<String, Long> operations(EyeView method, ViewTask look) {
        if (!(method instanceof CheckedView counted)) return Map.of();
        var counting = new CountingArithmetic();
        counted.count(counting, look.theta(), look.phi(), look.rho(), look.points().clone());
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
    public Format<EyeView, ViewTask, Images> format() {
        return new ViewFormat(this);
    }
}
