package rasterlab.engine.spline.function;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.contract.SplineFunction.Promise;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Putting a piecewise cubic function through points.
 *
 * <p>A method is held to what it promises: a smooth one to the cubic spline, one that keeps the
 * shape to the monotone cubic. The widths are rounded, then the elimination rounds a few times per
 * row, and rows far away hardly count; values within 10⁻¹² of the largest are therefore exact.
 */
public final class SplineFunctionTopic
        implements Topic<SplineFunction, SplineProblem, SplineValues> {
    private static final double ROUNDING = 1e-12;

    /** A millionth of the largest value: no picture shows it. */
    private static final double USABLE = 1e-6;

    @Override
    public String name() {
        return "spline-function";
    }

    @Override
    public String lab() {
        return "spline";
    }

    @Override
    public Class<SplineFunction> contract() {
        return SplineFunction.class;
    }

    @Override
    public SplineFunctionFormat format() {
        return new SplineFunctionFormat(this);
    }

    @Override
    public List<Method<SplineFunction>> methods() {
        return SplineMethods.all();
    }

    @Override
    public List<Hazard<SplineProblem>> hazards() {
        return SplineHazards.all();
    }

    @Override
    public List<Workload<SplineProblem>> workloads() {
        return SplineWorkloads.all();
    }

    @Override
    public List<Mutant<SplineFunction>> mutants() {
        return SplineFunctionMutants.all();
    }

    @Override
    public List<Slip<SplineFunction>> slips(SplineFunction right) {
        return SplineFunctionSlips.of(right);
    }

    @Override
    public SplineValues run(SplineFunction method, SplineProblem problem, int limit) {
        double[] coefficients = method.coefficients(problem.x(), problem.y(), problem.ends());
        int items = Math.min(limit, problem.at().length);
        double[] places = Arrays.copyOf(problem.at(), items);
        var values =
                new SplineValues(
                        method.promise(),
                        coefficients.length,
                        values(problem, coefficients, places));
        if (items < problem.at().length) throw new LimitReached(limit, values);
        return values;
    }

    /**
     * The values by the coefficients, never refusing any: that would pass for the method's refusal.
     */
    private static double[] values(SplineProblem problem, double[] coefficients, double[] places) {
        if (coefficients.length != problem.coefficients() || coefficients.length == 0) {
            var none = new double[places.length];
            Arrays.fill(none, Double.NaN);
            return none;
        }
        return new PiecewiseCubic(problem.x(), coefficients, problem.ends()).unchecked(places);
    }

    @Override
    public long spend(SplineFunction method, SplineProblem problem) {
        double[] coefficients = method.coefficients(problem.x(), problem.y(), problem.ends());
        return coefficients.length / 4 + 1;
    }

    /** {@inheritDoc} Without values where the problem has no spline. */
    @Override
    public SplineValues exact(SplineProblem problem, int limit) {
        if (!solvable(problem)) return new SplineValues(Promise.SMOOTH, 0, new double[0]);
        double[] values = new ExactSpline(problem).values();
        return new SplineValues(
                Promise.SMOOTH,
                problem.coefficients(),
                Arrays.copyOf(values, Math.min(limit, values.length)));
    }

    private static boolean solvable(SplineProblem problem) {
        double[] x = problem.x();
        boolean fits = x.length >= 2 && x.length == problem.y().length;
        for (int i = 0; fits && i < x.length; i++)
            fits =
                    Double.isFinite(problem.y()[i])
                            && Double.isFinite(x[i])
                            && (i == 0 || x[i] > x[i - 1]);
        boolean closes =
                problem.ends().kind() != SplineEnds.Kind.PERIODIC
                        || fits && problem.y()[0] == problem.y()[x.length - 1];
        return fits && closes && Double.isFinite(x[x.length - 1] - x[0]);
    }

    @Override
    public Deviation compare(SplineProblem problem, SplineValues exact, SplineValues actual) {
        return SplineComparison.compare(problem, exact, actual);
    }

    /**
     * The right values of a method with that promise.
     *
     * @param exact of a problem that has a spline
     */
    public static double[] right(SplineProblem problem, SplineValues exact, Promise promise) {
        return SplineComparison.right(problem, exact, promise);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= ROUNDING && deviation.missing() + deviation.extra() == 0;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE && deviation.missing() + deviation.extra() == 0;
    }

    /** Steps and those out of the ordinary, counted by the walk; of a student's method nothing. */
    @Override
    public Map<String, Long> operations(SplineFunction method, SplineProblem problem) {
        if (!(method instanceof SteppedSpline stepped)) return Map.of();
        SplineWalk walk = stepped.walk(problem.x(), problem.y(), problem.ends());
        long steps = 0;
        while (walk.advance()) steps++;
        return Map.of("steps", steps, "swaps-or-limits", walk.exceptions());
    }

    @Override
    public String item() {
        return "knot";
    }

    @Override
    public String errorUnit() {
        return "of the largest value";
    }
}
