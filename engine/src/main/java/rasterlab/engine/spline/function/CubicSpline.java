package rasterlab.engine.spline.function;

import java.util.Arrays;
import rasterlab.contract.SplineEnds;

/**
 * The cubic spline: through every point, with neither slope nor second derivative jumping.
 *
 * <p>The unknowns are the second derivatives M at the knots. Equal slopes on both sides of knot i
 * are the equation {@code μ·M[i−1] + 2·M[i] + λ·M[i+1] = 6·(δ[i] − δ[i−1]) / (h[i−1] + h[i])} with
 * the shares μ = h[i−1]/(h[i−1] + h[i]) and λ = 1 − μ; the ends give two more. The pieces have 4·m
 * unknowns for the 4·m − 2 equations of the knots and two of the ends; linear second derivatives
 * through M leave these m + 1. The slopes at the knots would do too, but where a narrow piece lies
 * between wide ones they are nearly equal and their small differences carry everything. O(m) time
 * and memory.
 *
 * <p>Source: J. H. Ahlberg, E. N. Nilson, J. L. Walsh, The Theory of Splines and Their
 * Applications, 1967, chapter II.
 */
public final class CubicSpline implements SteppedSpline {
    @Override
    public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
        var knots = new Knots(x, y, ends);
        if (alreadyKnown(knots, ends.kind())) return knots.bent(known(knots));
        var equations = new CurvatureEquations(knots, ends);
        equations.walk().drain();
        return knots.bent(equations.curvatures());
    }

    @Override
    public SplineWalk walk(double[] x, double[] y, SplineEnds ends) {
        var knots = new Knots(x, y, ends);
        return alreadyKnown(knots, ends.kind())
                ? new TridiagonalWalk(new double[0], new double[0], new double[0])
                : new CurvatureEquations(knots, ends).walk();
    }

    @Override
    public String decisionFormula() {
        return "eliminate: pivot p[i]; substitute: second derivative M[i] ="
                + " (r[i] − u[i]·M[i+1] − v[i]·M[i+2]) / p[i], v[i] = 0 unless rows were swapped";
    }

    /** Straight line, constant or parabola: the ends leave nothing to solve. */
    private static boolean alreadyKnown(Knots knots, SplineEnds.Kind kind) {
        return knots.pieces == 1 && kind != SplineEnds.Kind.SLOPES
                || knots.pieces == 2 && kind == SplineEnds.Kind.NOT_A_KNOT;
    }

    private static double[] known(Knots knots) {
        var second = new double[knots.pieces + 1];
        if (knots.pieces == 2) Arrays.fill(second, knots.bend(0, 1) / 3);
        return second;
    }
}
