package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class PlaneFrameTest {
    private static final PlaneMap MAP =
            PlaneMap.fitting(
                    new Rectangle2D.Double(0, 0, 10, 10),
                    new Rectangle(0, 0, 400, 400),
                    PlaneAxes.GEOMETRY);

    /** A picture that keeps what it was told to leave. */
    private record Told(List<Rectangle> places, List<Line2D> lines, List<Rectangle2D> lit)
            implements PlanePicture {
        @Override
        public List<Rectangle2D> pixels(PlaneMap map, Rectangle view) {
            return lit;
        }

        @Override
        public List<Line2D> lines(PlaneMap map, Rectangle view) {
            return lines;
        }

        @Override
        public void paint(
                Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {}

        @Override
        public PlanePicture leaving(List<Rectangle> labels) {
            places.addAll(labels);
            return this;
        }
    }

    private static PlanePoint point(String label, double x, double y) {
        return new PlanePoint(label, x, y, PlanePoint.HandleShape.CIRCLE, label, label);
    }

    private static List<Rectangle> labelPlaces(PlanePoint... points) {
        return labelPlaces(new Rectangle(), List.of(), points);
    }

    private static List<Rectangle> labelPlaces(
            Rectangle covered, List<Line2D> lines, PlanePoint... points) {
        return labelPlaces(new Told(new ArrayList<>(), lines, List.of()), covered, points);
    }

    private static List<Rectangle> labelPlaces(
            Told picture, Rectangle covered, PlanePoint... points) {
        new PlaneFrame(
                        picture,
                        List.of(points),
                        "",
                        MAP,
                        400,
                        400,
                        covered,
                        1,
                        StageColors.LIGHT,
                        new Font(Font.SANS_SERIF, Font.PLAIN, 13),
                        Locale.ENGLISH)
                .painted(() -> false);
        return picture.places;
    }

    @Test
    void labelLiesOverNoOtherPoint() {
        Rectangle alone = labelPlaces(point("A1 0000", 3, 3), point("", 7, 7)).get(0);
        PlanePoint there =
                point("", MAP.worldX(alone.getCenterX()), MAP.worldY(alone.getCenterY()));
        PlanePoint opposite = point("", 10 - there.x(), 10 - there.y());
        List<Rectangle> places =
                labelPlaces(point("A1 0000", 3, 3), point("", 7, 7), there, opposite);
        assertEquals(5, places.size());
        for (Rectangle ring : places.subList(2, 5))
            assertFalse(ring.intersects(places.get(0)), ring + " under " + places.get(0));
    }

    @Test
    void labelThatTheUpperEdgePushesBackLiesBesideItsRing() {
        PlanePoint high = point("B3 0001", 5, MAP.worldY(Rulers.top() + 22));
        List<Rectangle> places = labelPlaces(high, point("", 5, 1));
        Rectangle label = places.get(0);
        double x = MAP.viewX(high.x());
        double y = MAP.viewY(high.y());
        assertFalse(label.intersects(x - 7, y - 7, 14, 14), label + " on the ring at " + y);
        assertTrue(label.y >= Rulers.top(), label + " under the ruler");
    }

    @Test
    void labelsLeaveTheButtonsAndThePictureIsToldOfThem() {
        Rectangle alone = labelPlaces(point("A1 0000", 8, 2), point("", 2, 8)).get(0);
        List<Rectangle> places =
                labelPlaces(alone, List.of(), point("A1 0000", 8, 2), point("", 2, 8));
        assertFalse(alone.intersects(places.get(0)), places.toString());
        assertTrue(places.contains(alone), places.toString());
    }

    @Test
    void labelsOfPointsInOnePlaceLieBesideEachOther() {
        List<Rectangle> places =
                labelPlaces(point("A1 0000", 5, 5), point("B1 0000", 5.05, 5), point("", 7, 7));
        assertFalse(places.get(0).intersects(places.get(1)), places.toString());
    }

    @Test
    void pictureIsToldOfLabelsAndRings() {
        List<Rectangle> places = labelPlaces(point("A1 0000", 3, 3), point("", 7, 7));
        assertEquals(3, places.size(), "one label, two rings");
        assertFalse(places.get(0).contains(MAP.viewX(3), MAP.viewY(3)), "label on its point");
        assertTrue(places.get(1).contains(MAP.viewX(3), MAP.viewY(3)), places.toString());
        assertTrue(places.get(2).contains(MAP.viewX(7), MAP.viewY(7)), places.toString());
    }

    @Test
    @DisplayName("a handle that is moved aside leaves its label behind")
    void labelStandsBesideAHandleThatIsMovedAside() {
        List<Rectangle> places = labelPlaces(point("B", 1000, 5));
        Rectangle label = places.get(0);
        Rectangle ring = places.get(1);
        assertTrue(new Rectangle(400, 400).contains(label), label.toString());
        assertEquals(400 - 11, ring.getCenterX(), 1, "at the edge");
        assertEquals(ring.getCenterY(), label.getCenterY(), 40);
        assertEquals(ring.getCenterX(), label.getCenterX(), 60);
    }

    @Test
    @DisplayName("a label that follows its handle is drawn over the buttons or another label")
    void labelOfAHandleMovedAsideIsLeftOutWhereThereIsNoRoom() {
        var points = new ArrayList<PlanePoint>();
        for (int i = 0; i < 40; i++) points.add(point("A" + i + " 0000", 1000, 5));
        PlanePoint[] all = points.toArray(PlanePoint[]::new);
        Rectangle buttons = labelPlaces(all).get(0);
        List<Rectangle> places = labelPlaces(buttons, List.of(), all);
        List<Rectangle> labels = places.subList(0, places.size() - points.size() - 1);
        assertFalse(labels.isEmpty());
        for (Rectangle label : labels) assertFalse(label.intersects(buttons), label.toString());
        for (Rectangle one : labels)
            for (Rectangle other : labels)
                assertTrue(one == other || !one.intersects(other), one + " on " + other);
    }

    @Test
    @DisplayName("a label covers a line beside free places")
    void labelLeavesLinesClear() {
        var point = point("A1 0000", 3, 3);
        Rectangle before = labelPlaces(point, point("", 7, 7)).get(0);
        var line = new Line2D.Double(0, before.getCenterY(), MAP.viewX(3), before.getCenterY());
        Rectangle label =
                labelPlaces(new Rectangle(), List.of(line), point, point("", 7, 7)).get(0);
        assertTrue(before.intersectsLine(line));
        assertFalse(label.intersectsLine(line), label + " on the line");
    }

    @Test
    @DisplayName("a label hides lit pixels beside free ones, to leave a line clear")
    void labelLeavesPixelsClear() {
        PlanePoint[] points = {point("A1 0000", 3, 3), point("", 7, 7)};
        Rectangle before = labelPlaces(points).get(0);
        var lit = new ArrayList<Rectangle2D>();
        for (int x = 0; x < 400; x += 20)
            for (int y = (int) MAP.viewY(4); y < 400; y += 20)
                lit.add(new Rectangle2D.Double(x, y, 20, 20));
        var line = new Line2D.Double(0, MAP.viewY(4.2), 400, MAP.viewY(4.2));
        var picture = new Told(new ArrayList<>(), List.of(line), lit);
        Rectangle label = labelPlaces(picture, new Rectangle(), points).get(0);
        assertTrue(lit.stream().anyMatch(before::intersects), before.toString());
        assertFalse(lit.stream().anyMatch(label::intersects), label + " on a lit pixel");
    }
}
