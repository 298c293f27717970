package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.app.coordinates.figure.Viewpoint;
import rasterlab.app.coordinates.figure.Wireframe;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.transform.matrix.MatrixCall;

/**
 * The user's choice, which undo brings back.
 *
 * @param points of the subject, which can be dragged in the plane
 * @param items as a program writes them
 * @param selected number of an item, from 0; −1 where there is none
 * @param method that writes the matrices down
 * @param trial a hazard whose points and matrices these are, with the method that is tried on it;
 *     empty for a list that the user may change
 */
public record ListChoice(
        Subject subject,
        List<Double> points,
        List<ListItem> items,
        int selected,
        Reading reading,
        String method,
        Viewpoint viewpoint,
        Optional<Trial> trial) {
    /** The most matrices of a list. */
    public static final int MOST = 12;

    public ListChoice {
        Bounds.requireAtLeast("selected", selected, -1);
        points = List.copyOf(points);
        items = List.copyOf(items);
    }

    static ListChoice first() {
        return new ListChoice(
                Subject.SQUARE,
                Subject.SQUARE.wire().points(),
                Example.TWO_READINGS.items(),
                1,
                Reading.OBJECTS,
                "formula",
                Viewpoint.FIRST,
                Optional.empty());
    }

    int dimension() {
        return subject.wire().dimension();
    }

    Wireframe wire() {
        return new Wireframe(dimension(), points, subject.wire().edges());
    }

    /** The matrix that is selected, by its name; empty where none is or it has no name. */
    Optional<MatrixCall> selectedCall() {
        return selected < 0 || items.get(selected).free()
                ? Optional.empty()
                : Optional.of(items.get(selected).call());
    }

    /** The only matrix of the list, if it has that name. */
    Optional<double[]> only(String name) {
        return items.size() == 1 && items.get(0).name().equals(name)
                ? Optional.of(doubles(items.get(0).numbers()))
                : Optional.empty();
    }

    /** The coordinates of the points, one point after the other. */
    double[] coordinates() {
        return doubles(points);
    }

    private static double[] doubles(List<Double> numbers) {
        return numbers.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /**
     * The choice of another subject; what is tried ends with every change but that of how it is
     * looked at.
     */
    ListChoice with(Subject other) {
        boolean same = other.wire().dimension() == dimension();
        List<ListItem> kept = same ? items : Example.of(other.wire().dimension()).items();
        return changed(
                other, other.wire().points(), kept, Math.min(selected, kept.size() - 1), method);
    }

    ListChoice withMethod(String other) {
        return changed(subject, points, items, selected, other);
    }

    ListChoice withItems(List<ListItem> others, int chosen) {
        return changed(subject, points, others, inside(others, chosen), method);
    }

    ListChoice withPoint(int index, double x, double y) {
        var moved = new ArrayList<>(points);
        moved.set(2 * index, x);
        moved.set(2 * index + 1, y);
        return changed(subject, moved, items, selected, method);
    }

    /** This list, nothing being tried. */
    ListChoice withoutTrial() {
        return changed(subject, points, items, selected, method);
    }

    private ListChoice changed(
            Subject subject,
            List<Double> points,
            List<ListItem> items,
            int selected,
            String method) {
        return new ListChoice(
                subject, points, items, selected, reading, method, viewpoint, Optional.empty());
    }

    /** The points and matrices of a hazard, to try a method on. */
    ListChoice with(PointList list, Trial tried, String formula) {
        return new ListChoice(
                Subject.POINTS,
                list.points(),
                list.items(),
                list.items().size() - 1,
                reading,
                formula,
                viewpoint,
                Optional.of(tried));
    }

    /** This hazard by another method. */
    ListChoice with(Trial tried) {
        return new ListChoice(
                subject, points, items, selected, reading, method, viewpoint, Optional.of(tried));
    }

    ListChoice with(Reading other) {
        return seen(selected, other, viewpoint);
    }

    ListChoice with(Viewpoint other) {
        return seen(selected, reading, other);
    }

    ListChoice withSelected(int index) {
        return seen(inside(items, index), reading, viewpoint);
    }

    private ListChoice seen(int selected, Reading reading, Viewpoint viewpoint) {
        return new ListChoice(subject, points, items, selected, reading, method, viewpoint, trial);
    }

    private static int inside(List<ListItem> items, int index) {
        return Math.max(items.isEmpty() ? -1 : 0, Math.min(items.size() - 1, index));
    }
}
