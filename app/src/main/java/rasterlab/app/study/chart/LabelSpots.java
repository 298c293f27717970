package rasterlab.app.study.chart;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The spots around a point that its label may take, in a chart of points and lines without other
 * labels, and what speaks against each.
 *
 * <p>No spot is on a marker. One close to the point has no leader, hence is nearer to its own point
 * than to every other and on no line.
 */
final class LabelSpots {
    /** Half the side of a point's marker and a little more, in pixels. */
    static final int MARKER = 7;

    /**
     * The gap between a marker and a label beside it, and between a line and a label, in pixels.
     */
    private static final int GAP = 3;

    /** The gap between a label and the frame, in pixels. */
    private static final int EDGE = 3;

    /** The gaps between a marker and a label close to it, in pixels. */
    private static final int[] CLOSE = {3, 8};

    /** The gaps between a marker and a label with a leader, in pixels. */
    private static final int[] FAR = {14, 20, 28, 38, 50, 66, 86, 110, 140, 180, 230, 290};

    /** Directions around a point that are tried, at equal angles, clockwise from above it. */
    private static final int DIRECTIONS = 32;

    /** Points no further apart are read as one, in pixels. */
    private static final double ONE_PLACE = 3;

    /**
     * The distance by which a close label is nearer to its own point than to any other, in pixels.
     */
    private static final double NEARER = 1;

    /** A label with a leader keeps so far from other points' markers if it can, in pixels. */
    private static final int KEEPS_OFF = 7;

    /** Points in one row with a label, and so far from it, may be taken for its own, in pixels. */
    private static final int LEVEL = 30;

    // Penalties of a spot, in pixels of a leader line that are as bad.
    private static final double NOT_AT_ONCE = 0.05;
    private static final double NOT_BESIDE = 3;
    private static final double LEVEL_WITH_OTHER = 60;
    private static final double HAS_LEADER = 40;
    private static final double BESIDE_OTHER = 25;
    private static final double CROSSES_LINE = 15;
    private static final double ON_LINE = 150;
    private static final double CROSSES_MARKER = 300;
    private static final double CROSSES_OVERLAPPING = 60;
    private static final double LEFT_OUT = 3000;

    /** The spot of a label that is left out. */
    static final LabelSpot NOWHERE = new LabelSpot(Optional.empty(), LEFT_OUT, new Rectangle());

    private final Rectangle inside;
    private final List<Point> points;
    private final List<Line2D> lines;

    /**
     * @param place empty for {@link #NOWHERE}
     * @param cost what speaks against it, in pixels of a leader that are as bad
     * @param reach around label and leader; those of two spots that do not touch are apart
     */
    record LabelSpot(Optional<LabelPlaces.LabelPlace> place, double cost, Rectangle reach) {
        private static LabelSpot at(LabelPlaces.LabelPlace place, double cost) {
            Rectangle reach = grown(place.box(), LabelPlaces.GAP, 1);
            place.leader().ifPresent(leader -> reach.add(leader.getBounds()));
            return new LabelSpot(Optional.of(place), cost, reach);
        }
    }

    /**
     * @param inside where labels may stand
     * @param points at which markers are drawn
     * @param lines between points
     */
    LabelSpots(Rectangle inside, List<Point> points, List<Line2D> lines) {
        this.inside = new Rectangle(inside);
        this.inside.grow(-EDGE, -EDGE);
        this.points = List.copyOf(points);
        this.lines = List.copyOf(lines);
    }

    /** The label's spots, the best first and {@link #NOWHERE} last. */
    List<LabelSpot> around(LabelPlaces.PointLabel label) {
        var spots = new ArrayList<LabelSpot>();
        for (int distance : CLOSE)
            for (int number = 0; number < DIRECTIONS; number++) {
                Rectangle box = box(label, distance, inTurn(number));
                if (isFree(box) && !isOnLine(box) && isNearest(label.point(), box))
                    spots.add(close(label, box, NOT_BESIDE * distance + NOT_AT_ONCE * number));
            }
        for (int distance : FAR)
            for (int number = 0; number < DIRECTIONS; number++) {
                Rectangle box = box(label, distance, inTurn(number));
                if (isFree(box)) spots.add(far(label, box, distance + NOT_AT_ONCE * number));
            }
        spots.sort(Comparator.comparingDouble(LabelSpot::cost));
        spots.add(NOWHERE);
        return spots;
    }

    private LabelSpot close(LabelPlaces.PointLabel label, Rectangle box, double away) {
        double cost = isLevelWithOther(label.point(), box) ? LEVEL_WITH_OTHER + away : away;
        return LabelSpot.at(new LabelPlaces.LabelPlace(box, Optional.empty()), cost);
    }

    private LabelSpot far(LabelPlaces.PointLabel label, Rectangle box, double away) {
        Line2D leader = leader(label.point(), box);
        double cost = HAS_LEADER + away;
        if (isOnLine(box)) cost += ON_LINE;
        if (isBesideOther(label.point(), box)) cost += BESIDE_OTHER;
        cost += CROSSES_LINE * lines.stream().filter(leader::intersectsLine).count();
        cost += markersCrossed(label.point(), leader);
        return LabelSpot.at(new LabelPlaces.LabelPlace(box, Optional.of(leader)), cost);
    }

    private static Rectangle marker(Point point) {
        return new Rectangle(point.x - MARKER, point.y - MARKER, 2 * MARKER, 2 * MARKER);
    }

    private boolean isFree(Rectangle box) {
        Rectangle free = grown(box, GAP, 0);
        return inside.contains(box) && points.stream().noneMatch(p -> free.intersects(marker(p)));
    }

    private boolean isOnLine(Rectangle box) {
        return lines.stream().anyMatch(grown(box, GAP, 0)::intersectsLine);
    }

    /** Whether the box is nearer to its point than to every other. */
    private boolean isNearest(Point point, Rectangle box) {
        double near = point.distance(nearest(point, box));
        return points.stream()
                .filter(other -> other.distance(point) > ONE_PLACE)
                .allMatch(other -> other.distance(nearest(other, box)) >= near + NEARER);
    }

    /** Whether the box is in one row with another point nearby, and not with its own. */
    private boolean isLevelWithOther(Point point, Rectangle box) {
        Rectangle row = grown(box, LEVEL, 1);
        return !row.contains(point) && points.stream().anyMatch(row::contains);
    }

    private boolean isBesideOther(Point point, Rectangle box) {
        Rectangle around = grown(box, KEEPS_OFF, KEEPS_OFF);
        return points.stream()
                .filter(other -> other.distance(point) > ONE_PLACE)
                .anyMatch(other -> around.intersects(marker(other)));
    }

    /** The cost of a leader for the markers that it crosses, but for those at its own point. */
    private double markersCrossed(Point point, Line2D leader) {
        double cost = 0;
        for (Point other : points) {
            if (other.distance(point) <= ONE_PLACE) continue;
            if (!marker(other).contains(point))
                cost += leader.intersects(marker(other)) ? CROSSES_MARKER : 0;
            else if (leader.ptSegDist(other) < MARKER) cost += CROSSES_OVERLAPPING;
        }
        return cost;
    }

    static Rectangle grown(Rectangle box, int across, int down) {
        var grown = new Rectangle(box);
        grown.grow(across, down);
        return grown;
    }

    /**
     * The turn in which sides are tried: above, below, right and left first, then those between
     * them.
     */
    private static int inTurn(int number) {
        int[] quarters = {0, 16, 8, 24};
        int[] between = {0, 4, 2, -2, 1, -1, 3, -3};
        return Math.floorMod(quarters[number % 4] + between[number / 4], DIRECTIONS);
    }

    /** The box around a point, so far from its marker. */
    private static Rectangle box(LabelPlaces.PointLabel label, int distance, int turn) {
        Point point = label.point();
        Dimension size = label.size();
        double angle = 2 * Math.PI * turn / DIRECTIONS;
        double right = square(Math.sin(angle));
        double down = -square(Math.cos(angle));
        double x = point.x + right * (MARKER + distance + size.width / 2.0);
        double y = point.y + down * (MARKER + distance + size.height / 2.0);
        return new Rectangle(
                (int) Math.round(x - size.width / 2.0),
                (int) Math.round(y - size.height / 2.0),
                size.width,
                size.height);
    }

    /** The way from a place on a circle to one on the square around it, part by part. */
    private static double square(double part) {
        return Math.max(-1, Math.min(1, part * Math.sqrt(2)));
    }

    /** The line from the edge of a point's marker to the nearest place of the box. */
    private static Line2D leader(Point point, Rectangle box) {
        Point end = nearest(point, grown(box, 1, 0));
        double away = MARKER / Math.max(MARKER, point.distance(end));
        return new Line2D.Double(
                point.x + away * (end.x - point.x),
                point.y + away * (end.y - point.y),
                end.x,
                end.y);
    }

    /** The place of the box that is nearest to the point. */
    private static Point nearest(Point point, Rectangle box) {
        return new Point(
                Math.max(box.x, Math.min(box.x + box.width, point.x)),
                Math.max(box.y, Math.min(box.y + box.height, point.y)));
    }
}
