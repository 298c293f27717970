package rasterlab.engine.light.shade;

import java.util.EnumMap;
import java.util.List;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;
import rasterlab.contract.Reflection;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.SharedAnswer;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.study.WrongLength;

/**
 * One light on points of surfaces.
 *
 * <p>Each method is held against the formula with its own specular term. The error is the largest
 * difference of a share. Up to 10⁻¹² counts as exact: the highest shininess, 200, makes 200
 * roundings of a cosine's one. An output is usable within a level of a picture, 1/255.
 */
public final class ShadeTopic implements Topic<PointShader, LitPoints, Shades> {
    private static final double CORRECT = 1e-12;
    private static final double USABLE = 1 / 255.0;

    @Override
    public String name() {
        return "shade";
    }

    @Override
    public String lab() {
        return "light";
    }

    @Override
    public Class<PointShader> contract() {
        return PointShader.class;
    }

    @Override
    public List<Method<PointShader>> methods() {
        return ShadeMethods.all();
    }

    @Override
    public List<Hazard<LitPoints>> hazards() {
        return ShadeHazards.all();
    }

    @Override
    public List<Workload<LitPoints>> workloads() {
        return ShadeWorkloads.all();
    }

    @Override
    public List<Mutant<PointShader>> mutants() {
        return ShadeMutants.all();
    }

    @Override
    public List<Slip<PointShader>> slips(PointShader right) {
        return ShadeSlips.of(right);
    }

    @Override
    public Shades run(PointShader method, LitPoints points, int limit) {
        var rgb = new EnumMap<Reflection, double[]>(Reflection.class);
        List<LitPoint> all = points.first(limit);
        var intensities = new double[3 * all.size()];
        double[] before = all.isEmpty() ? null : method.intensity(all.get(0));
        for (int i = 0; i < all.size(); i++) {
            double[] one = method.intensity(all.get(i));
            SharedAnswer.requireNew(one, null, before);
            before = one;
            WrongLength.require(3, one.length, "shares");
            System.arraycopy(one, 0, intensities, 3 * i, 3);
        }
        rgb.put(method.reflection(), intensities);
        return new Shades(rgb);
    }

    @Override
    public long spend(PointShader method, LitPoints points) {
        long shares = 0;
        for (LitPoint point : points.points()) shares += method.intensity(point).length;
        return shares / 3;
    }

    @Override
    public Shades exact(LitPoints points, int limit) {
        var rgb = new EnumMap<Reflection, double[]>(Reflection.class);
        List<LitPoint> all = points.first(limit);
        for (Reflection reflection : Reflection.values()) {
            var intensities = new double[3 * all.size()];
            for (int i = 0; i < all.size(); i++)
                System.arraycopy(
                        ExactShade.intensity(all.get(i), reflection), 0, intensities, 3 * i, 3);
            rgb.put(reflection, intensities);
        }
        return new Shades(rgb);
    }

    @Override
    public Deviation compare(LitPoints points, Shades exact, Shades actual) {
        double worst = 0;
        String first = "";
        long count = 0;
        for (var entry : actual.rgb().entrySet()) {
            double[] right = exact.rgb().get(entry.getKey());
            double[] is = entry.getValue();
            count = right.length / 3;
            for (int i = 0; i < right.length; i++) {
                double error = difference(right[i], is[i]);
                if (error > 0 && first.isEmpty())
                    first =
                            "%s of point %d is %s, right is %s"
                                    .formatted(color(i), i / 3, is[i], written(right[i]));
                worst = Math.max(worst, error);
            }
        }
        return new Deviation(worst, 0, 0, count, first);
    }

    private static double difference(double right, double is) {
        double error = Math.abs(right - is);
        // Where no answer exists, only a refusal is right.
        return Double.isNaN(error) ? Double.POSITIVE_INFINITY : error;
    }

    private static String color(int index) {
        return List.of("red", "green", "blue").get(index % 3);
    }

    private static String written(double right) {
        return Double.isNaN(right) ? "no answer" : "" + right;
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
    public String item() {
        return "point";
    }

    @Override
    public String errorUnit() {
        return "of full intensity";
    }

    @Override
    public Format<PointShader, LitPoints, Shades> format() {
        return new ShadeFormat(this);
    }
}
