package rasterlab.exercises.drawing;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import rasterlab.exercises.score.Message;

/** Tells what the pictures of a plane show, to people who do not see them. */
final class PlaneTexts {
    /** Figures of one list whose coordinates are told. */
    private static final int MOST_TOLD = 8;

    /** A polygon of more vertices is told by its first one and their number. */
    private static final int MOST_VERTICES = 12;

    private final PlaneToPixels view;
    private final List<PlaneFigure> given;
    private final int xDigits;
    private final int yDigits;

    PlaneTexts(PlaneToPixels view, List<PlaneFigure> given) {
        this.view = view;
        this.given = given;
        xDigits = digits(view.box().x());
        yDigits = digits(view.box().y());
    }

    /** Significant digits that tell numbers of a range apart, be it narrow and far from 0. */
    private static int digits(AxisRange range) {
        double largest = Math.max(Math.abs(range.low()), Math.abs(range.high()));
        double common = Math.log10(largest) - Math.log10(range.half());
        return NumberText.USUAL_DIGITS + (int) Math.max(0, Math.min(11, Math.floor(common)));
    }

    Message expected(List<PlaneFigure> figures) {
        return plot().and(list("drawing.plane.given", given))
                .and(list("drawing.plane.expected", figures));
    }

    Message actual(List<PlaneFigure> figures) {
        return plot().and(list("drawing.plane.actual", figures));
    }

    Message difference(PlaneComparison figures) {
        Message turned = turned(figures.turned());
        if (figures.missing().isEmpty() && figures.extra().isEmpty())
            return turned.isEmpty() ? Message.of("drawing.same") : turned;
        Message counts =
                Message.of(
                        "drawing.plane.counts",
                        figures.agreeing().size(),
                        figures.missing().size(),
                        figures.extra().size());
        return counts.and(first(figures)).and(turned);
    }

    /** The figures that are there but run the other way; nothing where none does. */
    private Message turned(List<PlaneFigure> figures) {
        List<PlaneFigure> segments =
                figures.stream()
                        .filter(one -> one.form() == PlaneFigure.FigureKind.SEGMENT)
                        .toList();
        int others = figures.size() - segments.size();
        Message said =
                segments.isEmpty()
                        ? Message.NONE
                        : Message.of(
                                "drawing.plane.exchanged",
                                segments.size(),
                                usual(segments.get(0).points().get(0)),
                                usual(segments.get(0).points().get(1)));
        return others > 0 ? said.and(Message.of("drawing.plane.turned", others)) : said;
    }

    /** The part of the plane that is shown, and how. */
    private Message plot() {
        PlaneBox box = view.box();
        Message said =
                Message.of(
                                "drawing.plane.box",
                                NumberText.of(box.x().low(), xDigits),
                                NumberText.of(box.x().high(), xDigits),
                                NumberText.of(box.y().low(), yDigits),
                                NumberText.of(box.y().high(), yDigits))
                        .and(Message.of(view.isUp() ? "drawing.plane.up" : "drawing.plane.down"));
        return box.sameScale() ? said : said.and(Message.of("drawing.plane.scales"));
    }

    /** How many figures there are, the first of them, and which are not drawn whole. */
    private Message list(String key, List<PlaneFigure> figures) {
        Message said = Message.of(key, figures.size());
        for (PlaneFigure each : figures.subList(0, Math.min(MOST_TOLD, figures.size())))
            said = said.and(figure(each));
        long endless = figures.stream().filter(each -> !each.isFinite()).count();
        long beyond =
                figures.stream()
                        .filter(each -> each.isFinite() && view.reachesBeyond(each))
                        .count();
        if (endless > 0) said = said.and(Message.of("drawing.plane.endless", endless));
        return beyond > 0 ? said.and(Message.of("drawing.plane.beyond", beyond)) : said;
    }

    private Message figure(PlaneFigure figure) {
        List<CasePoint> points = figure.points();
        String all =
                points.stream()
                        .limit(MOST_VERTICES)
                        .map(this::usual)
                        .collect(Collectors.joining(" "));
        return switch (figure.form()) {
            case POINT -> Message.of("drawing.plane.point", all);
            case SEGMENT -> ends("drawing.plane.segment", points);
            case WINDOW -> ends("drawing.plane.window", points);
            case POLYGON -> polygon(points, all);
        };
    }

    private Message polygon(List<CasePoint> vertices, String all) {
        if (vertices.isEmpty()) return Message.of("drawing.plane.polygon-empty");
        return vertices.size() <= MOST_VERTICES
                ? Message.of("drawing.plane.polygon", all)
                : Message.of("drawing.plane.polygon-long", vertices.size(), usual(vertices.get(0)));
    }

    private Message ends(String key, List<CasePoint> points) {
        return Message.of(key, usual(points.get(0)), usual(points.get(1)));
    }

    private Message first(PlaneComparison figures) {
        Optional<PlaneComparison.VertexDifference> first = figures.first();
        if (first.isPresent()) {
            CasePoint expected = first.get().expected();
            CasePoint actual = first.get().actual();
            int x = Math.max(xDigits, NumberText.telling(expected.x(), actual.x()));
            int y = Math.max(yDigits, NumberText.telling(expected.y(), actual.y()));
            return Message.of("drawing.plane.first", point(expected, x, y), point(actual, x, y));
        }
        return figures.missing().isEmpty()
                ? start("drawing.plane.first-extra", figures.extra().get(0))
                : start("drawing.plane.first-missing", figures.missing().get(0));
    }

    private Message start(String key, PlaneFigure figure) {
        return figure.points().isEmpty()
                ? Message.NONE
                : Message.of(key, usual(figure.points().get(0)));
    }

    private String usual(CasePoint point) {
        return point(point, xDigits, yDigits);
    }

    private static String point(CasePoint point, int x, int y) {
        return "(" + NumberText.of(point.x(), x) + ", " + NumberText.of(point.y(), y) + ")";
    }
}
