package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.coordinates.figure.Viewpoint;
import rasterlab.app.coordinates.figure.Wire;

/**
 * What the user chose, and what undo brings back.
 *
 * @param points of the subject, which can be dragged in the plane
 * @param items as a program writes them
 * @param selected number of an item, from 0; −1 where there is none
 * @param method that writes the matrices down
 */
public record ListChoice(
        Subject subject,
        List<Double> points,
        List<ListItem> items,
        int selected,
        Reading reading,
        String method,
        Viewpoint viewpoint) {
    /** The most matrices of a list. */
    public static final int MOST = 12;

    public ListChoice {
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
                Viewpoint.FIRST);
    }

    int dimension() {
        return subject.wire().dimension();
    }

    Wire wire() {
        return new Wire(dimension(), points, subject.wire().edges());
    }

    ListChoice with(Subject other) {
        boolean same = other.wire().dimension() == dimension();
        List<ListItem> kept = same ? items : Example.of(other.wire().dimension()).items();
        return new ListChoice(
                other,
                other.wire().points(),
                kept,
                Math.min(selected, kept.size() - 1),
                reading,
                method,
                viewpoint);
    }

    ListChoice with(Reading other) {
        return new ListChoice(subject, points, items, selected, other, method, viewpoint);
    }

    ListChoice withMethod(String other) {
        return new ListChoice(subject, points, items, selected, reading, other, viewpoint);
    }

    ListChoice with(Viewpoint other) {
        return new ListChoice(subject, points, items, selected, reading, method, other);
    }

    ListChoice withItems(List<ListItem> others, int chosen) {
        return new ListChoice(
                subject,
                points,
                others,
                Math.max(others.isEmpty() ? -1 : 0, Math.min(others.size() - 1, chosen)),
                reading,
                method,
                viewpoint);
    }

    ListChoice withSelected(int index) {
        return withItems(items, index);
    }

    /** Points of space in the place of the subject. */
    ListChoice with(List<Double> xyz) {
        return new ListChoice(Subject.POINTS, xyz, items, selected, reading, method, viewpoint);
    }

    ListChoice withPoint(int index, double x, double y) {
        var moved = new ArrayList<>(points);
        moved.set(2 * index, x);
        moved.set(2 * index + 1, y);
        return new ListChoice(subject, moved, items, selected, reading, method, viewpoint);
    }
}
