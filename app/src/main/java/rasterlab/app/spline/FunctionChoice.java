package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.spline.function.SplineProblem;

/**
 * The user's choice, which undo brings back.
 *
 * @param knots in the order of their numbers, which need not be that of their x
 * @param method name of the method that finds the function
 * @param comparison name of a second method, "" for none
 */
public record FunctionChoice(List<Place> knots, SplineEnds ends, String method, String comparison) {
    private static final int MOST = 40;

    public FunctionChoice {
        knots = List.copyOf(knots);
    }

    double[] x() {
        return knots.stream().mapToDouble(Place::x).toArray();
    }

    double[] y() {
        return knots.stream().mapToDouble(Place::y).toArray();
    }

    SplineProblem problem(double... at) {
        return new SplineProblem(x(), y(), ends, at, false);
    }

    FunctionChoice withKnots(List<Place> others) {
        return new FunctionChoice(others, ends, method, comparison);
    }

    FunctionChoice withProblem(SplineProblem problem) {
        var places = new ArrayList<Place>();
        for (int i = 0; i < problem.x().length; i++)
            places.add(new Place(problem.x()[i], problem.y()[i]));
        return new FunctionChoice(places, problem.ends(), method, comparison);
    }

    /** Other ends; periodic ones bring the last knot to the first one's value. */
    FunctionChoice withEnds(SplineEnds others) {
        var next = new FunctionChoice(knots, others, method, comparison);
        return knots.isEmpty() ? next : next.moved(0, knots.get(0));
    }

    FunctionChoice withMethod(String other) {
        return new FunctionChoice(knots, ends, other, comparison);
    }

    FunctionChoice withComparison(String other) {
        return new FunctionChoice(knots, ends, method, other);
    }

    /** A knot elsewhere; where the ends are periodic, both end knots keep one value. */
    FunctionChoice moved(int knot, Place to) {
        var next = new ArrayList<>(knots);
        next.set(knot, to);
        int last = knots.size() - 1;
        boolean end = knot == 0 || knot == last;
        if (end && ends.kind() == SplineEnds.Kind.PERIODIC) {
            int other = last - knot;
            next.set(other, new Place(next.get(other).x(), to.y()));
        }
        return withKnots(next);
    }

    /** One knot more, between those to its left and right. */
    FunctionChoice added(Place knot) {
        if (knots.size() >= MOST) return this;
        int index = 0;
        while (index < knots.size() && knots.get(index).x() < knot.x()) index++;
        var more = new ArrayList<>(knots);
        more.add(index, knot);
        boolean end = index == 0 || index == knots.size();
        var next = withKnots(more);
        return end ? next.moved(index, knot) : next;
    }

    /** The choice without a knot, unless only two are left. */
    FunctionChoice removed(int knot) {
        if (knots.size() <= 2) return this;
        var fewer = new ArrayList<>(knots);
        fewer.remove(knot);
        return withKnots(fewer).withEnds(ends);
    }
}
