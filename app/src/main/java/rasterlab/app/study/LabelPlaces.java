package rasterlab.app.study;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Where labels of points stand in a chart: close to their points, or further off with a leader. */
final class LabelPlaces {
    /** Half the side of a point's marker and a little more, in pixels. */
    static final int MARKER = 7;

    /** Between two labels in a row, in pixels, so that they are not read as one number. */
    private static final int GAP = 3;

    /** Between a label and the frame, in pixels. */
    private static final int EDGE = 3;

    /** Between a marker and a label close to it, in pixels. */
    private static final int[] CLOSE = {3, 8};

    /** Between a marker and a label with a leader, in pixels. */
    private static final int[] FAR = {14, 24, 36, 50, 70, 95, 130, 170, 220, 280};

    /** Directions around a point that are tried, at equal angles, clockwise from above it. */
    private static final int DIRECTIONS = 32;

    private final Rectangle inside;
    private final List<Rectangle> markers;
    private final List<Line2D> lines;
    private final List<Rectangle> labels = new ArrayList<>();

    /**
     * @param box of the label
     * @param leader from the point's marker to the box; empty where the label is close to it
     */
    record Place(Rectangle box, Optional<Line2D> leader) {}

    /**
     * @param inside where labels may stand
     * @param points at which markers are drawn
     * @param lines between points
     */
    LabelPlaces(Rectangle inside, List<Point> points, List<Line2D> lines) {
        this.inside = new Rectangle(inside);
        this.inside.grow(-EDGE, -EDGE);
        markers = points.stream().map(LabelPlaces::marker).toList();
        this.lines = new ArrayList<>(lines);
    }

    private static Rectangle marker(Point point) {
        return new Rectangle(point.x - MARKER, point.y - MARKER, 2 * MARKER, 2 * MARKER);
    }

    /** Takes a place close to the point, on no label, marker or line; empty if there is none. */
    Optional<Place> close(Point point, Dimension label) {
        return boxes(point, label, CLOSE)
                .filter(this::isFree)
                .filter(this::isOnNoLine)
                .findFirst()
                .map(box -> taken(new Place(box, Optional.empty())));
    }

    /**
     * Takes the nearest place further off, whose leader crosses no label. If there is such a place,
     * it crosses no marker either and the label stands on no line; if there is none, rather the
     * label stands on a line. None where labels and markers leave no room at all.
     */
    Optional<Place> far(Point point, Dimension label) {
        return far(point, label, place -> isOnNoLine(place.box()) && crossesNoMarker(point, place))
                .or(() -> far(point, label, place -> crossesNoMarker(point, place)))
                .or(() -> far(point, label, place -> isOnNoLine(place.box())))
                .or(() -> far(point, label, place -> true))
                .map(this::taken);
    }

    private Optional<Place> far(Point point, Dimension label, Predicate<Place> wanted) {
        return boxes(point, label, FAR)
                .filter(this::isFree)
                .map(box -> new Place(box, Optional.of(leader(point, box))))
                .filter(place -> labels.stream().noneMatch(place.leader().get()::intersects))
                .filter(wanted)
                .findFirst();
    }

    private boolean crossesNoMarker(Point point, Place place) {
        return markers.stream()
                .filter(marker -> !marker.contains(point))
                .noneMatch(place.leader().get()::intersects);
    }

    private Place taken(Place place) {
        labels.add(place.box());
        place.leader().ifPresent(lines::add);
        return place;
    }

    private boolean isFree(Rectangle box) {
        var free = new Rectangle(box);
        free.grow(GAP, 0);
        return inside.contains(box)
                && Stream.of(markers, labels).flatMap(List::stream).noneMatch(free::intersects);
    }

    private boolean isOnNoLine(Rectangle box) {
        var free = new Rectangle(box);
        free.grow(GAP, 0);
        return lines.stream().noneMatch(free::intersectsLine);
    }

    /** Of a label around a point, so far from its marker, the nearest first. */
    private static Stream<Rectangle> boxes(Point point, Dimension label, int[] distances) {
        return IntStream.of(distances)
                .boxed()
                .flatMap(
                        distance ->
                                IntStream.range(0, DIRECTIONS)
                                        .map(LabelPlaces::inTurn)
                                        .mapToObj(turn -> box(point, label, distance, turn)));
    }

    /** Above, below, right and left first, then those between them. */
    private static int inTurn(int number) {
        int[] quarters = {0, 16, 8, 24};
        int[] between = {0, 4, 2, -2, 1, -1, 3, -3};
        return Math.floorMod(quarters[number % 4] + between[number / 4], DIRECTIONS);
    }

    private static Rectangle box(Point point, Dimension label, int distance, int turn) {
        double angle = 2 * Math.PI * turn / DIRECTIONS;
        double right = square(Math.sin(angle));
        double down = -square(Math.cos(angle));
        double x = point.x + right * (MARKER + distance + label.width / 2.0);
        double y = point.y + down * (MARKER + distance + label.height / 2.0);
        return new Rectangle(
                (int) Math.round(x - label.width / 2.0),
                (int) Math.round(y - label.height / 2.0),
                label.width,
                label.height);
    }

    /** From a place on a circle to one on the square around it, part by part. */
    private static double square(double part) {
        return Math.max(-1, Math.min(1, part * Math.sqrt(2)));
    }

    /** From the edge of a point's marker to the nearest place of the box. */
    private static Line2D leader(Point point, Rectangle box) {
        double x = Math.max(box.x - 1.0, Math.min(box.getMaxX() + 1, point.x));
        double y = Math.max(box.y, Math.min(box.getMaxY(), point.y));
        double away = MARKER / Math.max(MARKER, point.distance(x, y));
        return new Line2D.Double(
                point.x + away * (x - point.x), point.y + away * (y - point.y), x, y);
    }
}
