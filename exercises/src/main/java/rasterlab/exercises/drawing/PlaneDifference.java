package rasterlab.exercises.drawing;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.exercises.drawing.PlaneFigure.FigureKind;

/**
 * Draws the difference of two sets of figures: what agrees whole and dark, what is missing dashed
 * with minus marks, what is extra whole with plus marks.
 */
final class PlaneDifference {
    /** Two strokes that are nearer, in pixels, are drawn as one. */
    private static final double ONE_STROKE = 0.25;

    /** A difference of fewer pixels is not seen. */
    private static final double DOT = 4;

    /** Pairs of strokes to compare; where there are more, each is wholly missing or extra. */
    private static final long MOST_PAIRS = 4_000_000;

    private static final int SAMPLES = 4;

    private final PlaneComparison figures;
    private final PlaneToPixels view;
    private final double slack;
    private final boolean many;
    private final List<Line2D> missing;
    private final List<Line2D> extra;
    private final List<Line2D> agreeing = new ArrayList<>();
    private final List<Line2D> missingParts = new ArrayList<>();
    private final List<Line2D> extraParts = new ArrayList<>();

    /**
     * @param tolerance in the units of the plane
     */
    PlaneDifference(PlaneComparison figures, PlaneToPixels view, double tolerance) {
        this.figures = figures;
        this.view = view;
        double pixels =
                Math.min(
                        tolerance / 2 / view.box().x().half() * view.plot().getWidth(),
                        tolerance / 2 / view.box().y().half() * view.plot().getHeight());
        slack = Math.max(ONE_STROKE, pixels);
        missing = strokes(figures.missing());
        extra = strokes(figures.extra());
        many = (long) missing.size() * extra.size() > MOST_PAIRS;
        for (Line2D stroke : missing) split(stroke, many ? List.of() : extra, missingParts);
        for (Line2D stroke : extra) split(stroke, many ? List.of() : missing, extraParts);
    }

    void paint(Graphics2D g) {
        var painter = new PlanePainter(g, view);
        for (PlaneFigure each : finite(figures.agreeing())) {
            painter.strokes(view.strokes(each), Ink.EXPECTED, PlanePictures.LINE);
            painter.dots(each, Ink.EXPECTED);
        }
        painter.strokes(agreeing, Ink.EXPECTED, PlanePictures.LINE);
        painter.strokes(extraParts, Ink.EXTRA, PlanePictures.LINE);
        painter.dashes(missingParts, Ink.MISSING, PlanePictures.LINE);
        List<PlaneFigure> wanted = finite(figures.missing());
        List<PlaneFigure> got = finite(figures.extra());
        List<Point2D> shared = shared(wanted, got);
        for (PlaneFigure each : got) corners(painter, each, shared, true);
        for (PlaneFigure each : wanted) corners(painter, each, shared, false);
        var marks = new PlaneMarks(view.plot());
        place().filter(place -> !isSeen(wanted, got)).ifPresent(painter::circle);
        mark(g, painter, marks, wanted, shared, false);
        mark(g, painter, marks, got, shared, true);
    }

    private void mark(
            Graphics2D g,
            PlanePainter painter,
            PlaneMarks marks,
            List<PlaneFigure> figures,
            List<Point2D> shared,
            boolean areExtra) {
        for (Line2D part : areExtra ? extraParts : missingParts) marks.mark(g, part, areExtra);
        Color color = areExtra ? Ink.EXTRA : Ink.MISSING;
        for (PlaneFigure each : figures) {
            if (painter.isOut(each)) {
                painter.arrow(each.vertices(), color);
                marks.mark(g, view.nearestPlace(each.vertices().get(0)), areExtra);
            } else if (each.form() == FigureKind.POINT) {
                Point2D place = view.corners(each).get(0);
                if (!isNear(place, shared, slack)) marks.mark(g, place, areExtra);
            }
        }
    }

    /** Draws the vertices of a figure, dark where the other side has the same. */
    private void corners(
            PlanePainter painter, PlaneFigure figure, List<Point2D> shared, boolean isExtra) {
        for (Point2D place : painter.dotted(figure)) {
            boolean point = figure.form() == FigureKind.POINT;
            if (isNear(place, shared, slack)) painter.dot(place, point, Ink.EXPECTED);
            else if (isExtra) painter.dot(place, point, Ink.EXTRA);
            else painter.ring(place, point, Ink.MISSING);
        }
    }

    /** The places at which both a missing and an extra figure have a vertex. */
    private List<Point2D> shared(List<PlaneFigure> wanted, List<PlaneFigure> got) {
        if (many) return List.of();
        List<Point2D> there = got.stream().flatMap(each -> view.corners(each).stream()).toList();
        return wanted.stream()
                .flatMap(each -> view.corners(each).stream())
                .filter(place -> isNear(place, there, slack))
                .flatMap(
                        place -> there.stream().filter(each -> isNear(each, List.of(place), slack)))
                .distinct()
                .toList();
    }

    /** Where the first difference is; empty where it has no place in the plot. */
    Optional<Point2D> place() {
        Stream<CasePoint> first =
                figures.first()
                        .map(each -> Stream.of(each.expected(), each.actual()))
                        .orElse(Stream.empty());
        Stream<CasePoint> wrong =
                Stream.of(figures.missing(), figures.extra())
                        .flatMap(List::stream)
                        .flatMap(each -> each.points().stream());
        return Stream.concat(first, wrong)
                .filter(each -> each.isFinite() && view.box().contains(each))
                .findFirst()
                .map(view::place);
    }

    /**
     * Whether anything that is missing is as far from all that is extra as can be seen, or back.
     */
    private boolean isSeen(List<PlaneFigure> wanted, List<PlaneFigure> got) {
        return many
                || isApart(missingParts, extra)
                || isApart(extraParts, missing)
                || isAnyApart(points(wanted), points(got))
                || isAnyApart(points(got), points(wanted))
                || Stream.of(wanted, got)
                        .flatMap(List::stream)
                        .anyMatch(each -> view.reachesBeyond(each) && view.strokes(each).isEmpty());
    }

    private static boolean isApart(List<Line2D> parts, List<Line2D> others) {
        for (Line2D part : parts)
            for (int i = 0; i <= SAMPLES; i++) {
                double x = part.getX1() + (part.getX2() - part.getX1()) * i / SAMPLES;
                double y = part.getY1() + (part.getY2() - part.getY1()) * i / SAMPLES;
                if (others.stream().allMatch(each -> each.ptSegDist(x, y) > DOT)) return true;
            }
        return false;
    }

    private static boolean isAnyApart(List<Point2D> places, List<Point2D> others) {
        return places.stream().anyMatch(place -> !isNear(place, others, DOT));
    }

    private static boolean isNear(Point2D place, List<Point2D> others, double distance) {
        return others.stream().anyMatch(other -> other.distance(place) <= distance);
    }

    private List<Point2D> points(List<PlaneFigure> some) {
        return some.stream()
                .filter(each -> each.form() == FigureKind.POINT)
                .flatMap(each -> view.corners(each).stream())
                .toList();
    }

    private void split(Line2D stroke, List<Line2D> others, List<Line2D> open) {
        StrokeParts parts = StrokeParts.of(stroke, others, slack);
        agreeing.addAll(parts.covered());
        open.addAll(parts.open());
    }

    private List<Line2D> strokes(List<PlaneFigure> some) {
        return finite(some).stream().flatMap(each -> view.strokes(each).stream()).toList();
    }

    private static List<PlaneFigure> finite(List<PlaneFigure> some) {
        return some.stream().filter(PlaneFigure::isFinite).toList();
    }
}
