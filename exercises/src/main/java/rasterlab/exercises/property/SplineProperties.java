package rasterlab.exercises.property;

import java.util.List;
import java.util.Optional;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.spline.function.SplineProblem;
import rasterlab.engine.spline.function.SplineValues;
import rasterlab.exercises.property.Relation.AnsweredInput;
import rasterlab.exercises.property.Relation.Broken;
import rasterlab.exercises.property.Relation.Equivalence;

/** Properties of functions made of cubic pieces. */
final class SplineProperties {
    /**
     * A piece that is wider than its neighbour by more would be foretold with too much rounding.
     */
    private static final double MOST_WIDER = 4;

    /** Places that are asked for in each piece: its left end and two within it. */
    private static final int IN_PIECE = 3;

    static final List<Property<SplineProblem, SplineValues>> ALL =
            List.of(
                    new Property<>(
                            "spline-function",
                            "second-derivative-continuous",
                            SplineProperties::isEven,
                            new Smooth()));

    private SplineProperties() {}

    private static boolean isEven(SplineProblem problem) {
        double[] x = problem.x();
        if (x.length < 3 || problem.ends().kind() == SplineEnds.Kind.PERIODIC) return false;
        for (int i = 1; i < x.length; i++) if (!(x[i] > x[i - 1])) return false;
        for (int i = 1; i + 1 < x.length; i++)
            if (x[i + 1] - x[i] > MOST_WIDER * (x[i] - x[i - 1])) return false;
        return true;
    }

    /**
     * The relation that two neighbouring pieces differ by a multiple of (x − knot)³ alone, so that
     * value, slope and second derivative go on at the knot: the left piece and the right end tell
     * the right piece.
     */
    private static final class Smooth implements Relation<SplineProblem, SplineValues> {
        @Override
        public List<SplineProblem> furtherInputs(SplineProblem problem, SplineValues answer) {
            double[] x = problem.x();
            double[] at = new double[IN_PIECE * (x.length - 1) + 1];
            for (int i = 0; i < at.length; i++) {
                int piece = i / IN_PIECE;
                double share = i % IN_PIECE / (double) IN_PIECE;
                at[i] = share == 0 ? x[piece] : x[piece] + share * (x[piece + 1] - x[piece]);
            }
            return List.of(new SplineProblem(x, problem.y(), problem.ends(), at, false));
        }

        @Override
        public Optional<Broken<SplineProblem, SplineValues>> broken(
                AnsweredInput<SplineProblem, SplineValues> first,
                List<AnsweredInput<SplineProblem, SplineValues>> beside,
                Equivalence<SplineProblem, SplineValues> alike) {
            AnsweredInput<SplineProblem, SplineValues> all = beside.get(0);
            double[] at = all.input().at();
            double[] y = all.output().y();
            if (y.length != at.length) return Optional.empty();
            double[] foretold = y.clone();
            for (int knot = IN_PIECE; knot + IN_PIECE < at.length; knot += IN_PIECE) {
                double rest = y[knot + IN_PIECE] - leftPiece(at, y, knot, at[knot + IN_PIECE]);
                for (int i = 1; i < IN_PIECE; i++) {
                    double share = (at[knot + i] - at[knot]) / (at[knot + IN_PIECE] - at[knot]);
                    foretold[knot + i] =
                            leftPiece(at, y, knot, at[knot + i]) + rest * share * share * share;
                }
            }
            SplineValues wanted =
                    new SplineValues(all.output().promise(), all.output().coefficients(), foretold);
            return alike.test(all.input(), wanted, all.output())
                    ? Optional.empty()
                    : Optional.of(new Broken<>(all, wanted));
        }

        /** The cubic through the four values up to the knot, by J. L. Lagrange's formula. */
        private static double leftPiece(double[] at, double[] y, int knot, double x) {
            double sum = 0;
            for (int i = knot - IN_PIECE; i <= knot; i++) {
                double share = y[i];
                for (int j = knot - IN_PIECE; j <= knot; j++)
                    if (j != i) share *= (x - at[j]) / (at[i] - at[j]);
                sum += share;
            }
            return sum;
        }
    }
}
