package rasterlab.engine.spline.function;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.study.Workload;

/** Uneven knots with values of a random walk, the four kinds of ends in turn. */
final class SplineWorkloads {
    private static final long SEED = 1978;

    private SplineWorkloads() {}

    static List<Workload<SplineProblem>> all() {
        return List.of(knots(10), knots(100), knots(1_000), knots(10_000));
    }

    private static Workload<SplineProblem> knots(int size) {
        var problems = new ArrayList<SplineProblem>();
        for (SplineEnds.Kind kind : SplineEnds.Kind.values())
            problems.add(random(size, kind, new Random(SEED + size + kind.ordinal())));
        return new Workload<>("knots-" + size, size, problems);
    }

    /** Widths between 0.1 and 1.1, a value of about √size, three places in every piece. */
    static SplineProblem random(int knots, SplineEnds.Kind kind, Random random) {
        var x = new double[knots];
        var y = new double[knots];
        var at = new double[3 * (knots - 1)];
        for (int i = 1; i < knots; i++) {
            x[i] = x[i - 1] + 0.1 + random.nextDouble();
            y[i] = y[i - 1] + random.nextGaussian();
            for (int k = 0; k < 3; k++)
                at[3 * (i - 1) + k] = x[i - 1] + (x[i] - x[i - 1]) * random.nextDouble();
        }
        boolean slopes = kind == SplineEnds.Kind.SLOPES;
        if (kind == SplineEnds.Kind.PERIODIC) y[knots - 1] = y[0];
        var ends = new SplineEnds(kind, slopes ? 1 : 0, slopes ? -2 : 0);
        return new SplineProblem(x, y, ends, at, false);
    }
}
