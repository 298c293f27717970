package rasterlab.exercises.drawing;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.List;
import rasterlab.exercises.drawing.PlaneFigure.FigureKind;

/** Draws figures of the plane into a picture, each cut to the plot. */
final class PlanePainter {
    /** A figure of more vertices has no dots on them. */
    private static final int MOST_DOTS = 40;

    /** Radius of a point that is a figure of its own. */
    private static final double POINT = 4.5;

    /** Radius of an end or a vertex. */
    private static final double VERTEX = 3;

    /** Radius of the ring around a difference that is too small to see. */
    private static final double CIRCLE = 13;

    private static final float[] DASHES = {7, 5};

    private final Graphics2D g;
    private final PlaneToPixels view;

    PlanePainter(Graphics2D g, PlaneToPixels view) {
        this.g = g;
        this.view = view;
    }

    /** Fills the polygons. */
    void fills(List<PlaneFigure> figures, Color color) {
        g.setColor(Ink.pale(color));
        for (PlaneFigure each : figures)
            if (each.form() == FigureKind.POLYGON && each.isFinite()) g.fill(view.inside(each));
    }

    /** Draws edges and points, and arrows to figures beyond the plot. */
    void lines(List<PlaneFigure> figures, Color color, double width) {
        List<PlaneFigure> finite = figures.stream().filter(PlaneFigure::isFinite).toList();
        for (PlaneFigure each : finite) {
            strokes(view.strokes(each), color, width);
            dots(each, color);
        }
        for (PlaneFigure each : finite) if (isOut(each)) arrow(each.vertices(), color);
    }

    /** Draws whole strokes. */
    void strokes(List<Line2D> strokes, Color color, double width) {
        draw(strokes, color, new BasicStroke((float) width));
    }

    /** Draws dashed strokes. */
    void dashes(List<Line2D> strokes, Color color, double width) {
        draw(
                strokes,
                color,
                new BasicStroke(
                        (float) width,
                        BasicStroke.CAP_BUTT,
                        BasicStroke.JOIN_MITER,
                        10,
                        DASHES,
                        0));
    }

    private void draw(List<Line2D> strokes, Color color, BasicStroke stroke) {
        g.setColor(color);
        g.setStroke(stroke);
        strokes.forEach(g::draw);
    }

    /** The places of a figure's vertices in the plot that get a dot. */
    List<Point2D> dotted(PlaneFigure figure) {
        boolean bare = figure.form() == FigureKind.WINDOW || figure.points().size() > MOST_DOTS;
        return bare ? List.of() : view.corners(figure);
    }

    /**
     * Draws a dot.
     *
     * @param point whether it is a figure of its own, not only a vertex
     */
    void dot(Point2D place, boolean point, Color color) {
        g.setColor(color);
        g.fill(disc(place, point ? POINT : VERTEX));
    }

    /** Draws the same as a ring. */
    void ring(Point2D place, boolean point, Color color) {
        double radius = (point ? POINT : VERTEX) - 0.5;
        g.setColor(Ink.PAPER);
        g.fill(disc(place, radius));
        g.setColor(color);
        g.setStroke(new BasicStroke(1.5f));
        g.draw(disc(place, radius));
    }

    /** Dots on points, ends and vertices. */
    void dots(PlaneFigure figure, Color color) {
        for (Point2D place : dotted(figure)) dot(place, figure.form() == FigureKind.POINT, color);
    }

    /** Whether a finite figure has points, but none in the plot. */
    boolean isOut(PlaneFigure figure) {
        return !figure.points().isEmpty()
                && view.corners(figure).isEmpty()
                && view.strokes(figure).isEmpty()
                && view.inside(figure).getCurrentPoint() == null;
    }

    /** Draws an arrow at the border that points to a figure beyond it. */
    void arrow(List<CasePoint> vertices, Color color) {
        CasePoint first = vertices.get(0);
        Point2D tip = view.nearestPlace(first);
        double x = sign(view.x(first.x()), view.plot().getMinX(), view.plot().getMaxX());
        double y = sign(view.y(first.y()), view.plot().getMinY(), view.plot().getMaxY());
        double length = Math.hypot(x, y);
        if (length == 0) return;
        double dx = x / length;
        double dy = y / length;
        var arrow = new Path2D.Double();
        arrow.moveTo(tip.getX(), tip.getY());
        arrow.lineTo(tip.getX() - 11 * dx - 5 * dy, tip.getY() - 11 * dy + 5 * dx);
        arrow.lineTo(tip.getX() - 11 * dx + 5 * dy, tip.getY() - 11 * dy - 5 * dx);
        arrow.closePath();
        g.setColor(color);
        g.fill(arrow);
    }

    /** Draws a ring around a place that is too small to see. */
    void circle(Point2D place) {
        g.setColor(Ink.PAPER);
        g.setStroke(new BasicStroke(5));
        g.draw(disc(place, CIRCLE));
        g.setColor(Ink.EXTRA);
        g.setStroke(new BasicStroke(2.5f));
        g.draw(disc(place, CIRCLE));
    }

    private static int sign(double value, double low, double high) {
        return value < low ? -1 : value > high ? 1 : 0;
    }

    private static Ellipse2D disc(Point2D center, double radius) {
        return new Ellipse2D.Double(
                center.getX() - radius, center.getY() - radius, 2 * radius, 2 * radius);
    }
}
