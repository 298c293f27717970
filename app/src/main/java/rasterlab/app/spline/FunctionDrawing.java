package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.spline.function.Overshoot;
import rasterlab.engine.spline.function.PiecewiseCubic;
import rasterlab.engine.spline.function.SplineFunctionTopic;
import rasterlab.engine.spline.function.SplineProblem;
import rasterlab.engine.spline.function.SplineValues;
import rasterlab.engine.spline.function.SplineWalk;
import rasterlab.engine.spline.function.SteppedSpline;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Topic;

/**
 * The function that one method put through the knots.
 *
 * @param coefficients a, b, c, d of each piece; none unless the search ended well
 * @param graph places along the function, {@value #EACH} to a piece
 * @param error against the exact function, as a share of the largest value
 * @param right whether the topic calls it exact
 * @param message why there is nothing to draw; "" where there is
 */
public record FunctionDrawing(
        String method,
        List<double[]> coefficients,
        List<Place> graph,
        List<Overshoot> overshoots,
        List<FunctionStep> steps,
        double error,
        boolean right,
        FunctionEnding ending,
        String message) {
    private static final int EACH = 48;

    /** How the search for the function came to its end. */
    public enum FunctionEnding {
        ENDED,
        REFUSED,
        /** The method answered what has no value somewhere. */
        UNDRAWABLE,
        CRASHED
    }

    /**
     * One step of the method.
     *
     * @param index row of the equations or number of the piece, from 0
     * @param knot the knot that the row stands for; −1 where the step is about a piece
     * @param decision see {@link SteppedSpline#decisionFormula}; of an answer how far it is off
     * @param answer what a method without steps of its own answers at one place
     */
    public record FunctionStep(
            String phase, int index, int knot, double decision, Optional<FunctionAnswer> answer) {
        public FunctionStep {
            Bounds.requireAtLeast("index", index, 0);
            Bounds.requireAtLeast("knot", knot, -1);
        }
    }

    /**
     * The values of a method's function at one place, beside the right ones.
     *
     * @param wrong whether the topic does not call it exact
     */
    public record FunctionAnswer(double x, double value, double right, boolean wrong) {
        /** The answers at all places of a problem; none where it has no function. */
        private static List<FunctionAnswer> all(
                Topic<SplineFunction, SplineProblem, SplineValues> topic,
                SplineProblem problem,
                SplineValues exact,
                SplineValues actual) {
            if (exact.y().length == 0 || actual.coefficients() != exact.coefficients())
                return List.of();
            double[] right = SplineFunctionTopic.right(problem, exact, actual.promise());
            var answers = new ArrayList<FunctionAnswer>();
            for (int i = 0; i < right.length; i++)
                answers.add(
                        new FunctionAnswer(
                                problem.at()[i],
                                actual.y()[i],
                                right[i],
                                !isRight(topic, problem, exact, actual, i)));
            return List.copyOf(answers);
        }

        private static boolean isRight(
                Topic<SplineFunction, SplineProblem, SplineValues> topic,
                SplineProblem problem,
                SplineValues exact,
                SplineValues actual,
                int place) {
            var alone =
                    new SplineProblem(
                            problem.x(),
                            problem.y(),
                            problem.ends(),
                            new double[] {problem.at()[place]},
                            problem.shape());
            return topic.correct(topic.compare(alone, at(exact, place), at(actual, place)));
        }

        private static SplineValues at(SplineValues values, int place) {
            return new SplineValues(
                    values.promise(), values.coefficients(), new double[] {values.y()[place]});
        }
    }

    /**
     * @throws IllegalArgumentException if the topic has no method of that name
     */
    static FunctionDrawing of(
            Topic<SplineFunction, SplineProblem, SplineValues> topic,
            String method,
            FunctionChoice choice) {
        SplineFunction function = topic.method(method).implementation();
        double[] coefficients;
        try {
            coefficients = function.coefficients(choice.x(), choice.y(), choice.ends());
        } catch (IllegalArgumentException e) {
            return nothing(method, FunctionEnding.REFUSED, e.getMessage());
        } catch (RuntimeException e) {
            return nothing(method, FunctionEnding.CRASHED, e.toString());
        }
        try {
            return found(topic, method, coefficients, choice);
        } catch (IllegalArgumentException e) {
            return nothing(method, FunctionEnding.UNDRAWABLE, e.getMessage());
        } catch (RuntimeException e) {
            return nothing(method, FunctionEnding.CRASHED, e.toString());
        }
    }

    /** The places along one piece, from its first knot to its second. */
    List<Place> graphOf(int piece) {
        return graph.subList(EACH * piece, EACH * (piece + 1) + 1);
    }

    /** How far the function is outside its knots' values at most; 0 where it never is. */
    public double worstOvershoot() {
        return overshoots.stream().mapToDouble(Overshoot::by).max().orElse(0);
    }

    private static FunctionDrawing nothing(String method, FunctionEnding ending, String message) {
        return new FunctionDrawing(
                method,
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                Double.NaN,
                false,
                ending,
                message);
    }

    private static FunctionDrawing found(
            Topic<SplineFunction, SplineProblem, SplineValues> topic,
            String method,
            double[] all,
            FunctionChoice choice) {
        SplineFunction function = topic.method(method).implementation();
        double[] x = choice.x();
        double[] places = places(x);
        SplineProblem problem = choice.problem(coarse(places));
        int limit = problem.at().length;
        SplineValues exact = topic.exact(problem, limit);
        double[] values = new PiecewiseCubic(x, all, choice.ends()).at(places);
        var graph = new ArrayList<Place>();
        for (int i = 0; i < places.length; i++) graph.add(new Place(places[i], values[i]));
        SplineValues actual = topic.record(function, problem, limit);
        Deviation deviation = topic.compare(problem, exact, actual);
        return new FunctionDrawing(
                method,
                pieces(all),
                List.copyOf(graph),
                Overshoot.all(x, choice.y(), all),
                function instanceof SteppedSpline stepped
                        ? steps(stepped, choice)
                        : answers(problem, FunctionAnswer.all(topic, problem, exact, actual)),
                deviation.worst(),
                topic.correct(deviation),
                FunctionEnding.ENDED,
                "");
    }

    private static double[] places(double[] x) {
        var places = new double[EACH * (x.length - 1) + 1];
        for (int piece = 0; piece + 1 < x.length; piece++)
            for (int i = 0; i < EACH; i++)
                places[EACH * piece + i] = x[piece] + (x[piece + 1] - x[piece]) * i / EACH;
        places[places.length - 1] = x[x.length - 1];
        return places;
    }

    /** Every eighth place: the exact function is slow. */
    private static double[] coarse(double[] places) {
        var some = new double[(places.length - 1) / 8 + 1];
        for (int i = 0; i < some.length; i++) some[i] = places[8 * i];
        return some;
    }

    private static List<double[]> pieces(double[] all) {
        var pieces = new ArrayList<double[]>();
        for (int i = 0; i < all.length; i += 4)
            pieces.add(new double[] {all[i], all[i + 1], all[i + 2], all[i + 3]});
        return List.copyOf(pieces);
    }

    private static List<FunctionStep> answers(SplineProblem problem, List<FunctionAnswer> all) {
        return all.stream()
                .map(
                        one ->
                                new FunctionStep(
                                        "value",
                                        problem.piece(one.x()),
                                        -1,
                                        one.value() - one.right(),
                                        Optional.of(one)))
                .toList();
    }

    private static List<FunctionStep> steps(SteppedSpline function, FunctionChoice choice) {
        boolean rows = function.promise() == SplineFunction.Promise.SMOOTH;
        int first = choice.ends().kind() == SplineEnds.Kind.NOT_A_KNOT ? 1 : 0;
        var steps = new ArrayList<FunctionStep>();
        SplineWalk walk = function.walk(choice.x(), choice.y(), choice.ends());
        while (walk.advance()) {
            int knot = rows ? walk.index() + first : -1;
            steps.add(
                    new FunctionStep(
                            walk.phase(), walk.index(), knot, walk.decision(), Optional.empty()));
        }
        return List.copyOf(steps);
    }
}
