package rasterlab.exercises.drawing;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.exercises.drawing.PlaneFigure.FigureKind;

/**
 * The expected and the actual figures, matched. Two figures agree where their points do within a
 * tolerance; a segment may run either way, and a polygon may begin at any vertex and run either
 * way.
 */
final class PlaneComparison {
    /**
     * Vertices up to which every beginning of a polygon is tried to find where two differ first.
     */
    private static final int MOST_TURNED = 200;

    /**
     * The first place where two figures of one form differ.
     *
     * @param expected a vertex of the expected figure
     * @param actual the one that the actual figure has instead
     */
    record VertexDifference(CasePoint expected, CasePoint actual) {}

    private final double tolerance;
    private final List<PlaneFigure> agreeing = new ArrayList<>();
    private final List<PlaneFigure> missing = new ArrayList<>();
    private final List<PlaneFigure> extra;
    private final List<PlaneFigure> turned = new ArrayList<>();

    /**
     * @param tolerance the most by which a coordinate may differ
     */
    PlaneComparison(List<PlaneFigure> expected, List<PlaneFigure> actual, double tolerance) {
        this.tolerance = tolerance;
        extra = new ArrayList<>(actual);
        for (PlaneFigure figure : expected) {
            Optional<PlaneFigure> same =
                    extra.stream().filter(each -> agree(figure, each)).findFirst();
            (same.isPresent() ? agreeing : missing).add(figure);
            same.filter(each -> !agreeForwards(figure, each)).ifPresent(any -> turned.add(figure));
            same.ifPresent(extra::remove);
        }
    }

    /** The expected figures that are there. */
    List<PlaneFigure> agreeing() {
        return agreeing;
    }

    /** The agreeing figures that run the other way. */
    List<PlaneFigure> turned() {
        return turned;
    }

    /** The expected figures that are not there. */
    List<PlaneFigure> missing() {
        return missing;
    }

    /** The actual figures that are not expected. */
    List<PlaneFigure> extra() {
        return extra;
    }

    /**
     * Where the first missing figure and the extra one that is most like it differ; empty where no
     * extra one has its form and number of points.
     */
    Optional<VertexDifference> first() {
        if (missing.isEmpty()) return Optional.empty();
        PlaneFigure figure = missing.get(0);
        List<CasePoint> closest = null;
        double least = Double.POSITIVE_INFINITY;
        for (PlaneFigure each : extra) {
            if (each.form() != figure.form() || each.points().size() != figure.points().size())
                continue;
            for (List<CasePoint> order : orders(each)) {
                double distance = distance(figure.points(), order);
                if (closest != null && distance >= least) continue;
                closest = order;
                least = distance;
            }
        }
        return closest == null ? Optional.empty() : first(figure.points(), closest);
    }

    private Optional<VertexDifference> first(List<CasePoint> expected, List<CasePoint> actual) {
        for (int i = 0; i < expected.size(); i++)
            if (!expected.get(i).isNear(actual.get(i), tolerance))
                return Optional.of(new VertexDifference(expected.get(i), actual.get(i)));
        return Optional.empty();
    }

    private boolean agree(PlaneFigure one, PlaneFigure other) {
        return one.form() == other.form()
                && one.points().size() == other.points().size()
                && (one.points().isEmpty()
                        || orders(other).stream().anyMatch(order -> near(one.points(), order)));
    }

    /** Whether figures that agree do so as they run. */
    private boolean agreeForwards(PlaneFigure one, PlaneFigure other) {
        return one.points().size() < 2
                || orders(other).stream()
                        .filter(order -> order instanceof Turned ring && ring.step > 0)
                        .anyMatch(order -> near(one.points(), order));
    }

    private boolean near(List<CasePoint> one, List<CasePoint> other) {
        for (int i = 0; i < one.size(); i++)
            if (!one.get(i).isNear(other.get(i), tolerance)) return false;
        return true;
    }

    private static double distance(List<CasePoint> one, List<CasePoint> other) {
        double most = 0;
        for (int i = 0; i < one.size(); i++)
            most = Math.max(most, one.get(i).distance(other.get(i)));
        return most;
    }

    /** The points in every order that makes the same figure. */
    private static List<List<CasePoint>> orders(PlaneFigure figure) {
        List<CasePoint> points = figure.points();
        if (figure.form() == FigureKind.POINT || points.size() < 2) return List.of(points);
        var orders = new ArrayList<List<CasePoint>>();
        int starts =
                figure.form() == FigureKind.POLYGON && points.size() <= MOST_TURNED
                        ? points.size()
                        : 1;
        for (int start = 0; start < starts; start++) {
            orders.add(new Turned(points, start, 1));
            orders.add(new Turned(points, start + points.size() - 1, -1));
        }
        return orders;
    }

    /** A view of a ring of points from another start, forwards or backwards. */
    private static final class Turned extends java.util.AbstractList<CasePoint> {
        private final List<CasePoint> points;
        private final int start;
        private final int step;

        Turned(List<CasePoint> points, int start, int step) {
            this.points = points;
            this.start = start;
            this.step = step;
        }

        @Override
        public CasePoint get(int index) {
            return points.get(Math.floorMod(start + step * index, points.size()));
        }

        @Override
        public int size() {
            return points.size();
        }
    }
}
