package rasterlab.app.study.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LabelPlacesTest {
    private static final Rectangle CHART = new Rectangle(0, 0, 600, 400);
    private static final Dimension LABEL = new Dimension(60, 11);
    private static final Point MIDDLE = new Point(300, 200);

    /** The place of a label at that point, the only one of the chart. */
    private static LabelPlaces.LabelPlace only(
            Point point, List<Point> points, List<Line2D> lines) {
        return places(List.of(point), points, lines).get(0).orElseThrow();
    }

    private static List<Optional<LabelPlaces.LabelPlace>> places(
            List<Point> labelled, List<Point> points, List<Line2D> lines) {
        return LabelPlaces.of(
                CHART,
                points,
                lines,
                labelled.stream().map(point -> new LabelPlaces.PointLabel(point, LABEL)).toList());
    }

    private static List<Optional<LabelPlaces.LabelPlace>> places(List<Point> labelled) {
        return places(labelled, labelled, List.of());
    }

    /** A crowd of so many points, most of them near the middle. */
    private static List<Point> crowd(int seed, int points) {
        var random = new Random(seed);
        return IntStream.range(0, points)
                .mapToObj(
                        i ->
                                new Point(
                                        MIDDLE.x + (int) (40 * random.nextGaussian()),
                                        MIDDLE.y + (int) (25 * random.nextGaussian())))
                .toList();
    }

    private static Rectangle marker(Point point) {
        return new Rectangle(point.x - 6, point.y - 6, 12, 12);
    }

    private static double distance(Point point, Rectangle box) {
        double x = Math.max(box.getMinX(), Math.min(box.getMaxX(), point.x));
        double y = Math.max(box.getMinY(), Math.min(box.getMaxY(), point.y));
        return point.distance(x, y);
    }

    @ParameterizedTest(name = "a label lies on a point or another label in crowd {0}")
    @ValueSource(ints = {1, 2, 3, 4})
    void labelsLieOnNothing(int seed) {
        List<Point> crowd = crowd(seed, 24);
        List<LabelPlaces.LabelPlace> places =
                places(crowd).stream().flatMap(Optional::stream).toList();
        for (LabelPlaces.LabelPlace one : places) {
            for (LabelPlaces.LabelPlace two : places)
                if (one != two) {
                    assertFalse(one.box().intersects(two.box()), one + " on " + two);
                    assertFalse(
                            one.leader().filter(l -> l.intersects(two.box())).isPresent(),
                            one + " through " + two);
                }
            for (Point point : crowd)
                assertFalse(one.box().intersects(marker(point)), one + " on " + point);
        }
    }

    @ParameterizedTest(
            name = "a leader of crowd {0} begins at another point or ends beside its label")
    @ValueSource(ints = {1, 2, 3, 4})
    void leaderJoinsALabelToItsOwnPoint(int seed) {
        List<Point> crowd = crowd(seed, 24);
        List<Optional<LabelPlaces.LabelPlace>> places = places(crowd);
        int leaders = 0;
        for (int i = 0; i < crowd.size(); i++) {
            if (places.get(i).isEmpty() || places.get(i).get().leader().isEmpty()) continue;
            leaders++;
            LabelPlaces.LabelPlace place = places.get(i).get();
            Line2D leader = place.leader().get();
            assertEquals(LabelSpots.MARKER, crowd.get(i).distance(leader.getP1()), 1e-9);
            assertTrue(distance(rounded(leader), place.box()) <= 1.5, place.toString());
            assertEquals(
                    0,
                    new Line2D.Double(crowd.get(i), leader.getP2()).ptLineDist(leader.getP1()),
                    1e-6,
                    "it points at its point");
        }
        assertTrue(leaders > 3, leaders + " leaders in a crowd");
    }

    private static Point rounded(Line2D leader) {
        return new Point((int) Math.round(leader.getX2()), (int) Math.round(leader.getY2()));
    }

    @ParameterizedTest(name = "a label without a leader is as near to another point of crowd {0}")
    @ValueSource(ints = {1, 2, 3, 4, 5, 6})
    void labelWithoutALeaderIsNearestToItsOwnPoint(int seed) {
        List<Point> crowd = crowd(seed, 16);
        List<Optional<LabelPlaces.LabelPlace>> places = places(crowd);
        for (int i = 0; i < crowd.size(); i++) {
            Point own = crowd.get(i);
            Optional<LabelPlaces.LabelPlace> place =
                    places.get(i).filter(found -> found.leader().isEmpty());
            if (place.isEmpty()) continue;
            for (Point other : crowd)
                if (other.distance(own) > 3)
                    assertTrue(
                            distance(own, place.get().box()) < distance(other, place.get().box()),
                            place + " of " + own + " beside " + other);
        }
    }

    @Test
    @DisplayName("a label in one row with another point is read as that point's")
    void labelStandsInNoRowOfAnotherPoint() {
        var other = new Point(MIDDLE.x + 45, MIDDLE.y - 15);
        LabelPlaces.LabelPlace place = only(MIDDLE, List.of(MIDDLE, other), List.of());
        assertTrue(place.leader().isEmpty());
        assertTrue(place.box().getMinY() > other.y, place.toString());
    }

    @Test
    @DisplayName("a label has a leader as one that has room elsewhere took its only place beside")
    void labelGivesItsPlaceToOneThatHasNoOther() {
        var free = new Point(300, 206);
        var belowLines = new Point(300, 169);
        List<Line2D> lines =
                IntStream.rangeClosed(0, 9)
                        .<Line2D>mapToObj(
                                i -> new Line2D.Double(200, 100 + 8 * i, 400, 100 + 8 * i))
                        .toList();
        List<Point> points = List.of(free, belowLines);
        for (Optional<LabelPlaces.LabelPlace> place : places(points, points, lines))
            assertTrue(place.orElseThrow().leader().isEmpty(), place.toString());
    }

    @ParameterizedTest(
            name = "a label of {0} points at nearly one place is left out beside free room")
    @ValueSource(ints = {8, 12, 16})
    void labelsOfPointsAtOnePlaceAllFindRoom(int points) {
        List<Point> one =
                IntStream.range(0, points)
                        .mapToObj(i -> new Point(MIDDLE.x + i % 4, MIDDLE.y + i / 4))
                        .toList();
        assertEquals(points, places(one).stream().filter(Optional::isPresent).count());
    }

    @ParameterizedTest(name = "leaders cross beside places where they would not in crowd {0}")
    @ValueSource(ints = {1, 2, 3, 4})
    void leadersDoNotCross(int seed) {
        List<Line2D> leaders =
                places(crowd(seed, 16)).stream()
                        .flatMap(Optional::stream)
                        .flatMap(place -> place.leader().stream())
                        .toList();
        for (int i = 0; i < leaders.size(); i++)
            for (Line2D other : leaders.subList(0, i))
                assertFalse(leaders.get(i).intersectsLine(other), "leaders " + i + " of " + seed);
    }

    @Test
    @DisplayName("a point among others has no label, or one that nothing joins to it")
    void labelOfACrowdedPointStandsFurtherOffWithALeader() {
        List<Point> crowd =
                IntStream.range(0, 49)
                        .mapToObj(i -> new Point(240 + 20 * (i % 7), 140 + 20 * (i / 7)))
                        .toList();
        LabelPlaces.LabelPlace place = only(MIDDLE, crowd, List.of());
        assertTrue(place.leader().isPresent());
        for (Point point : crowd) assertFalse(place.box().contains(point), point.toString());
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
        Line2D leader = only(MIDDLE, wall, lines).leader().orElseThrow();
        for (Point other : wall.subList(1, wall.size()))
            assertFalse(leader.intersects(other.x - 7, other.y - 7, 14, 14), other.toString());
    }

    @Test
    @DisplayName("a label lies on the frame")
    void labelKeepsOffTheFrame() {
        var low = new Point(300, CHART.height - LabelSpots.MARKER);
        var crowd = List.of(low, new Point(300, low.y - 20), new Point(260, low.y));
        Rectangle box = only(low, crowd, List.of()).box();
        var free = new Rectangle(box);
        free.grow(3, 3);
        assertTrue(CHART.contains(free), box.toString());
    }

    @Test
    @DisplayName("a label of a point among many lines is left out")
    void labelStandsOnALineOnlyWhereThereIsNoOtherPlace() {
        var lines = new ArrayList<Line2D>();
        for (int y = 0; y < 400; y += 9) lines.add(new Line2D.Double(0, y, 600, y));
        assertTrue(only(MIDDLE, List.of(MIDDLE), lines).leader().isPresent());
    }

    @Test
    @DisplayName("labels of few points have other places than right above them, or leaders")
    void labelsOfFewPointsStandRightAboveThem() {
        List<Point> few = List.of(MIDDLE, new Point(200, 200), new Point(100, 100));
        for (int i = 0; i < few.size(); i++) {
            LabelPlaces.LabelPlace place = places(few).get(i).orElseThrow();
            assertTrue(place.leader().isEmpty());
            assertEquals(few.get(i).x, place.box().getCenterX(), 1);
            assertEquals(few.get(i).y - LabelSpots.MARKER - 3, place.box().getMaxY(), 1);
        }
    }
}
