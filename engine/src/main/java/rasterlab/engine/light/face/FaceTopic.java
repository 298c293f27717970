package rasterlab.engine.light.face;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rasterlab.contract.FaceShader;
import rasterlab.engine.color.Levels;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.study.WrongLength;

/**
 * Shading a face.
 *
 * <p>The error is the largest difference of a channel in levels of a picture. Up to 10⁻⁹ levels
 * count as exact, for rounding that the highest shininess makes 200 times as large. An output is
 * usable within one level.
 */
public final class FaceTopic implements Topic<FaceShader, FacePoints, double[]> {
    private static final double CORRECT = 1e-9;
    private static final double USABLE = 1;

    @Override
    public String name() {
        return "shade-face";
    }

    @Override
    public String lab() {
        return "light";
    }

    @Override
    public Class<FaceShader> contract() {
        return FaceShader.class;
    }

    @Override
    public List<Method<FaceShader>> methods() {
        return FaceMethods.all();
    }

    @Override
    public List<Hazard<FacePoints>> hazards() {
        return FaceHazards.all();
    }

    @Override
    public List<Workload<FacePoints>> workloads() {
        return FaceWorkloads.all();
    }

    @Override
    public List<Mutant<FaceShader>> mutants() {
        return FaceMutants.all();
    }

    @Override
    public List<Slip<FaceShader>> slips(FaceShader right) {
        return FaceSlips.of(right);
    }

    @Override
    public List<Mutant<FaceShader>> mutants(String method) {
        return method.equals(FaceMethods.GOURAUD) ? GouraudMutants.all() : mutants();
    }

    @Override
    public double[] run(FaceShader method, FacePoints points, int limit) {
        double[] shades = method.shade(points.face(), points.weights());
        WrongLength.require(points.weights().length, shades.length, "shares");
        return Arrays.copyOf(shades, (int) Math.min(3L * limit, shades.length));
    }

    @Override
    public long spend(FaceShader method, FacePoints points) {
        return method.shade(points.face(), points.weights()).length / 3;
    }

    @Override
    public double[] exact(FacePoints points, int limit) {
        double[] shades = ExactFace.shade(points);
        return Arrays.copyOf(shades, (int) Math.min(3L * limit, shades.length));
    }

    @Override
    public Deviation compare(FacePoints points, double[] exact, double[] actual) {
        double worst = 0;
        String first = "";
        for (int i = 0; i < exact.length; i++) {
            double error = Math.abs(exact[i] - actual[i]) * Levels.HIGHEST;
            if (Double.isNaN(error)) error = Double.POSITIVE_INFINITY;
            if (error > CORRECT && first.isEmpty())
                first =
                        "%s of point %d is %s, right is %s"
                                .formatted(
                                        List.of("red", "green", "blue").get(i % 3),
                                        i / 3,
                                        actual[i],
                                        Double.isNaN(exact[i]) ? "no answer" : "" + exact[i]);
            worst = Math.max(worst, error);
        }
        return new Deviation(worst, 0, 0, exact.length / 3, first);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= CORRECT;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE;
    }

    /** How often the formula is evaluated, whatever the number of points. */
    @Override
    public Map<String, Long> operations(FaceShader method, FacePoints points) {
        if (!(method instanceof SteppedFace stepped)) return Map.of();
        var formulas = new long[1];
        stepped.shade(points.face(), points.weights(), (place, n, intensity) -> formulas[0]++);
        return Map.of("formulas", formulas[0]);
    }

    @Override
    public String item() {
        return "pixel";
    }

    @Override
    public String errorUnit() {
        return "levels";
    }

    @Override
    public Format<FaceShader, FacePoints, double[]> format() {
        return new FaceFormat(this);
    }
}
