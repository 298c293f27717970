package rasterlab.exercises.drawing;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** Sets the signs − and + in small rings beside what is missing or extra, none on another. */
final class PlaneMarks {
    private static final double RADIUS = 7;

    /** Pixels between the centers of two marks, at least. */
    private static final double APART = 2 * RADIUS + 2;

    /** Parts shorter than that have their mark beside them. */
    private static final double SHORT = 3 * RADIUS;

    /** Marks of a kind; where there are more to set, the first ones tell enough. */
    private static final int MOST = 30;

    private static final double[] PLACES = {0.5, 0.25, 0.75};

    private final Rectangle2D plot;
    private final List<Point2D> taken = new ArrayList<>();
    private int missing;
    private int extra;

    PlaneMarks(Rectangle2D plot) {
        this.plot = plot;
    }

    /** Marks a part of a stroke. */
    void mark(Graphics2D g, Line2D part, boolean isExtra) {
        double length = part.getP1().distance(part.getP2());
        if (length >= SHORT)
            for (double place : PLACES) if (set(g, at(part, place), isExtra)) return;
        drawMark(g, at(part, PLACES[0]), direction(part, length), isExtra);
    }

    /** Marks a place that has no length, beside it. */
    void mark(Graphics2D g, Point2D place, boolean isExtra) {
        drawMark(g, place, new Point2D.Double(1, 1), isExtra);
    }

    /** Missing things have their mark on one side, extra ones on the other where there is room. */
    private void drawMark(Graphics2D g, Point2D place, Point2D direction, boolean isExtra) {
        double x = -direction.getY();
        double y = direction.getX();
        for (double distance : new double[] {APART, 2 * APART, 3 * APART})
            for (int side : isExtra ? new int[] {1, -1} : new int[] {-1, 1}) {
                var moved =
                        new Point2D.Double(
                                place.getX() + side * distance * x,
                                place.getY() + side * distance * y);
                if (set(g, moved, isExtra)) return;
            }
    }

    /** Draws a mark inside the plot unless one is there already. */
    private boolean set(Graphics2D g, Point2D place, boolean isExtra) {
        if ((isExtra ? extra : missing) >= MOST) return true;
        double room = RADIUS + 2;
        double x = Math.max(plot.getMinX() + room, Math.min(plot.getMaxX() - room, place.getX()));
        double y = Math.max(plot.getMinY() + room, Math.min(plot.getMaxY() - room, place.getY()));
        if (taken.stream().anyMatch(each -> each.distance(x, y) < APART)) return false;
        taken.add(new Point2D.Double(x, y));
        if (isExtra) extra++;
        else missing++;
        paint(g, x, y, isExtra);
        return true;
    }

    private static void paint(Graphics2D g, double x, double y, boolean isExtra) {
        Color color = isExtra ? Ink.EXTRA : Ink.MISSING;
        var ring = new Ellipse2D.Double(x - RADIUS, y - RADIUS, 2 * RADIUS, 2 * RADIUS);
        g.setColor(Ink.PAPER);
        g.fill(ring);
        g.setColor(color);
        g.setStroke(new BasicStroke(1.2f));
        g.draw(ring);
        g.setStroke(new BasicStroke(2));
        g.draw(new Line2D.Double(x - 4, y, x + 4, y));
        if (isExtra) g.draw(new Line2D.Double(x, y - 4, x, y + 4));
    }

    private static Point2D at(Line2D part, double share) {
        return new Point2D.Double(
                part.getX1() + share * (part.getX2() - part.getX1()),
                part.getY1() + share * (part.getY2() - part.getY1()));
    }

    /** A vector of length 1 along the part. */
    private static Point2D direction(Line2D part, double length) {
        return length == 0
                ? new Point2D.Double(1, 0)
                : new Point2D.Double(
                        (part.getX2() - part.getX1()) / length,
                        (part.getY2() - part.getY1()) / length);
    }
}
