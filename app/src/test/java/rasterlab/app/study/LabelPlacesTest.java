package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class LabelPlacesTest {
    private static final Rectangle CHART = new Rectangle(0, 0, 600, 400);
    private static final Dimension LABEL = new Dimension(60, 11);
    private static final Point MIDDLE = new Point(300, 200);

    @Test
    @DisplayName("a point among others has no label, or one that nothing joins to it")
    void labelOfACrowdedPointStandsFurtherOffWithALeader() {
        List<Point> crowd =
                IntStream.range(0, 49)
                        .mapToObj(i -> new Point(240 + 20 * (i % 7), 140 + 20 * (i / 7)))
                        .toList();
        var places = new LabelPlaces(CHART, crowd, List.of());
        assertTrue(places.close(MIDDLE, LABEL).isEmpty());
        LabelPlaces.Place place = places.far(MIDDLE, LABEL).orElseThrow();
        Line2D leader = place.leader().orElseThrow();
        assertEquals(LabelPlaces.MARKER, MIDDLE.distance(leader.getP1()), 1e-9);
        var touched = new Rectangle(place.box());
        touched.grow(2, 2);
        assertTrue(touched.contains(leader.getP2()), leader.getP2() + " beside " + place.box());
        for (Point point : crowd) assertFalse(place.box().contains(point), point.toString());
    }

    @Test
    @DisplayName("a leader runs through a label or another point")
    void leadersCrossNoLabelAndNoMarkerBesideFreePlaces() {
        Point other = new Point(300, 170);
        var points = List.of(MIDDLE, other, new Point(330, 200), new Point(270, 200));
        var places = new LabelPlaces(CHART, points, List.of());
        var taken = new ArrayList<LabelPlaces.Place>();
        for (int i = 0; i < 8; i++) taken.add(places.far(MIDDLE, LABEL).orElseThrow());
        for (LabelPlaces.Place one : taken)
            for (LabelPlaces.Place two : taken)
                if (one != two) {
                    assertFalse(one.box().intersects(two.box()));
                    assertFalse(one.leader().orElseThrow().intersects(two.box()));
                }
        Line2D first = taken.get(0).leader().orElseThrow();
        assertFalse(first.intersects(other.x - 7, other.y - 7, 14, 14));
    }

    @Test
    @DisplayName("a leader runs through another point so that its label is on no line")
    void leaderCrossesNoMarkerThoughItsLabelThenStandsOnALine() {
        var wall = new ArrayList<Point>(List.of(MIDDLE));
        for (int turn = 0; turn < 16; turn++)
            if (turn % 8 != 0)
                wall.add(
                        new Point(
                                (int) (MIDDLE.x + 22 * Math.sin(turn * Math.PI / 8)),
                                (int) (MIDDLE.y - 22 * Math.cos(turn * Math.PI / 8))));
        List<Line2D> lines =
                IntStream.range(0, 45)
                        .<Line2D>mapToObj(i -> new Line2D.Double(280, 9 * i, 320, 9 * i))
                        .toList();
        var places = new LabelPlaces(CHART, wall, lines);
        Line2D leader = places.far(MIDDLE, LABEL).orElseThrow().leader().orElseThrow();
        for (Point other : wall.subList(1, wall.size()))
            assertFalse(leader.intersects(other.x - 7, other.y - 7, 14, 14), other.toString());
    }

    @Test
    @DisplayName("a label lies on the frame")
    void labelKeepsOffTheFrame() {
        var low = new Point(300, CHART.height - LabelPlaces.MARKER);
        var crowd = List.of(low, new Point(300, low.y - 20), new Point(260, low.y));
        var places = new LabelPlaces(CHART, crowd, List.of());
        Rectangle box =
                places.close(low, LABEL).or(() -> places.far(low, LABEL)).orElseThrow().box();
        var free = new Rectangle(box);
        free.grow(3, 3);
        assertTrue(CHART.contains(free), box.toString());
    }

    @Test
    @DisplayName("a label of a point among many lines is left out")
    void labelStandsOnALineOnlyWhereThereIsNoOtherPlace() {
        var lines = new ArrayList<Line2D>();
        for (int y = 0; y < 400; y += 9) lines.add(new Line2D.Double(0, y, 600, y));
        var places = new LabelPlaces(CHART, List.of(MIDDLE), lines);
        assertTrue(places.close(MIDDLE, LABEL).isEmpty());
        assertTrue(places.far(MIDDLE, LABEL).isPresent());
    }

    @Test
    void closeLabelHasNoLeader() {
        var places = new LabelPlaces(CHART, List.of(MIDDLE), List.of());
        LabelPlaces.Place place = places.close(MIDDLE, LABEL).orElseThrow();
        assertTrue(place.leader().isEmpty());
        assertEquals(MIDDLE.x, place.box().getCenterX(), 1);
        assertEquals(MIDDLE.y - LabelPlaces.MARKER - 3, place.box().getMaxY(), 1);
    }
}
