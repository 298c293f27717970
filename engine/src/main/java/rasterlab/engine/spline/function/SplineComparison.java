package rasterlab.engine.spline.function;

import rasterlab.contract.SplineFunction.Promise;
import rasterlab.engine.study.Deviation;

/**
 * How far values are from those of the function that their method promises, as a share of the
 * largest |y| among knots and right values.
 *
 * <p>Where the problem asks for the shape, a value outside those of the two neighbouring knots is
 * wrong by as much, if the method promises the shape: a smooth function has to swing there.
 */
final class SplineComparison {
    private SplineComparison() {}

    static Deviation compare(SplineProblem problem, SplineValues exact, SplineValues actual) {
        int of = exact.y().length;
        if (of == 0)
            return actual.y().length == 0
                    ? Deviation.NONE
                    : new Deviation(0, 0, actual.y().length, 0, "values where no spline exists");
        if (actual.coefficients() != exact.coefficients())
            return new Deviation(
                    Double.POSITIVE_INFINITY,
                    0,
                    0,
                    of,
                    "%d coefficients where %d are right"
                            .formatted(actual.coefficients(), exact.coefficients()));
        double[] right = right(problem, exact, actual.promise());
        double scale = scale(problem, right);
        double worst = 0;
        int where = -1;
        for (int i = 0; i < of; i++) {
            double error = Math.abs(actual.y()[i] - right[i]) + overshoot(problem, i, actual);
            if (!(error / scale <= worst)) {
                worst = Double.isNaN(error) ? Double.POSITIVE_INFINITY : error / scale;
                where = i;
            }
        }
        return new Deviation(worst, 0, 0, of, where < 0 ? "" : text(problem, where, right, actual));
    }

    /** The right values of a method with that promise, where the problem has a spline. */
    static double[] right(SplineProblem problem, SplineValues exact, Promise promise) {
        return promise == Promise.SMOOTH ? exact.y() : new ExactMonotone(problem).values();
    }

    private static double scale(SplineProblem problem, double[] right) {
        double largest = Double.MIN_NORMAL;
        for (double y : problem.y()) largest = Math.max(largest, Math.abs(y));
        for (double y : right) largest = Math.max(largest, Math.abs(y));
        return largest;
    }

    private static double overshoot(SplineProblem problem, int i, SplineValues actual) {
        if (!problem.shape() || actual.promise() != Promise.SHAPE) return 0;
        double value = actual.y()[i];
        int piece = problem.piece(problem.at()[i]);
        double from = problem.y()[piece];
        double to = problem.y()[piece + 1];
        return Math.max(0, Math.max(value - Math.max(from, to), Math.min(from, to) - value));
    }

    private static String text(
            SplineProblem problem, int where, double[] right, SplineValues actual) {
        double at = problem.at()[where];
        double value = actual.y()[where];
        if (overshoot(problem, where, actual) == 0)
            return "at %s: %s instead of %s".formatted(at, value, right[where]);
        int piece = problem.piece(at);
        return "at %s: %s lies outside %s and %s, the values of knots %d and %d"
                .formatted(at, value, problem.y()[piece], problem.y()[piece + 1], piece, piece + 1);
    }
}
