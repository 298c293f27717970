package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import rasterlab.app.coordinates.figure.Chains;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.transform.matrix.MatrixTopic;

/**
 * The subject after each step of a list, as one of its two readings goes.
 *
 * @param cells of each item in the list's order, by the chosen method; empty when one is refused
 * @param right the same by the right formula
 * @param refused number of the first item that is refused, −1 for none
 * @param refusal why
 */
record ListScene(
        ListChoice choice,
        List<double[]> cells,
        List<double[]> right,
        int refused,
        String refusal) {
    ListScene {
        Bounds.requireAtLeast("refused", refused, -1);
    }

    static ListScene of(MatrixTopic topic, ListChoice choice) {
        MatrixFormula method = topic.method(choice.method()).implementation();
        MatrixFormula formula = topic.method("formula").implementation();
        var cells = new ArrayList<double[]>();
        var right = new ArrayList<double[]>();
        for (int i = 0; i < choice.items().size(); i++)
            try {
                cells.add(choice.items().get(i).cells(method));
                right.add(choice.items().get(i).cells(formula));
            } catch (IllegalArgumentException refusal) {
                return refused(choice, i, refusal);
            }
        for (int done = 1; done <= cells.size(); done++)
            try {
                for (List<double[]> all : List.of(cells, right)) {
                    requireImages(choice, all.subList(0, done));
                    requireImages(choice, all.subList(all.size() - done, all.size()));
                }
            } catch (IllegalArgumentException refusal) {
                return refused(choice, done - 1, refusal);
            }
        return new ListScene(choice, cells, right, -1, "");
    }

    private static ListScene refused(
            ListChoice choice, int item, IllegalArgumentException refusal) {
        return new ListScene(choice, List.of(), List.of(), item, refusal.getMessage());
    }

    /** Passes if the points can go through these matrices, the last one first. */
    private static void requireImages(ListChoice choice, List<double[]> matrices) {
        Chains.images(choice.dimension(), reversed(matrices), choice.wire().numbers());
    }

    boolean isRefused() {
        return refused >= 0;
    }

    int last() {
        return isRefused() ? 0 : cells.size();
    }

    /**
     * The matrices that the object has gone through after so many steps, in the order in which they
     * are applied to it.
     *
     * @param exact whether by the right formula
     */
    List<double[]> applied(int step, boolean exact) {
        List<double[]> all = exact ? right : cells;
        int done = Math.min(step, all.size());
        return reversed(
                choice.reading() == Reading.OBJECTS
                        ? all.subList(all.size() - done, all.size())
                        : all.subList(0, done));
    }

    private static List<double[]> reversed(List<double[]> list) {
        var copy = new ArrayList<>(list);
        Collections.reverse(copy);
        return copy;
    }

    /** The list's order of the items that are applied after so many steps, from 0. */
    int newest(int step) {
        return choice.reading() == Reading.OBJECTS ? cells.size() - step : step - 1;
    }

    /** Images of the subject's points; NaN where there is none. */
    double[] images(int step, boolean exact) {
        return images(choice.wire().numbers(), step, exact);
    }

    double[] images(double[] points, int step, boolean exact) {
        return Chains.images(choice.dimension(), applied(step, exact), points)
                .images()
                .coordinates();
    }

    /** H of the subject's points. */
    double[] h(int step) {
        return Chains.images(choice.dimension(), applied(step, false), choice.wire().numbers()).h();
    }

    /** The origin and a point of each axis of the frame that the steps have moved. */
    double[] frame(int step, double length) {
        int dimension = choice.dimension();
        var points = new double[(dimension + 1) * dimension];
        for (int axis = 0; axis < dimension; axis++) points[(axis + 1) * dimension + axis] = length;
        return images(points, step, false);
    }

    /** Whether the chosen method's picture differs from the right one. */
    boolean wrong() {
        if (isRefused()) return false;
        for (int i = 0; i < cells.size(); i++) {
            double[] a = cells.get(i);
            double[] b = right.get(i);
            double largest = Arrays.stream(b).map(Math::abs).max().orElse(1);
            for (int j = 0; j < a.length; j++)
                if (!(Math.abs(a[j] - b[j]) <= 1e-9 * largest)) return true;
        }
        return false;
    }
}
