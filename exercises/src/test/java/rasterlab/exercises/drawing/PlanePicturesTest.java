package rasterlab.exercises.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.exercises.drawing.PlaneFigure.point;
import static rasterlab.exercises.drawing.PlaneFigure.polygon;
import static rasterlab.exercises.drawing.PlaneFigure.segment;
import static rasterlab.exercises.drawing.PlaneFigure.window;

import java.awt.Color;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.score.CasePicture;

class PlanePicturesTest {
    private static final List<PlaneFigure> NONE = List.of();
    private static final List<PlaneFigure> WINDOW = List.of(window(0, 0, 10, 8));

    @Test
    void anAgreeingFigureIsDarkAndNothingIsMarked() {
        List<PlaneFigure> expected = List.of(segment(1, 2, 9, 2), polygon(1, 4, 5, 4, 5, 7));
        Seen seen = seen(expected, List.of(polygon(5, 4, 5, 7, 1, 4), segment(1, 2, 9, 2)));
        seen.assertComplete("the same figures in another order");
        assertEquals(0, Seen.count(seen.difference(), Ink.MISSING));
        assertEquals(0, Seen.count(seen.difference(), Ink.EXTRA));
        assertEquals(
                Seen.count(seen.expected(), Ink.EXPECTED),
                Seen.count(seen.difference(), Ink.EXPECTED));
        assertEquals("there is no difference", seen.differenceText("en"));
        assertEquals("различий нет", seen.differenceText("ru"));
    }

    @Test
    void figuresThatRunTheOtherWayAreTold() {
        List<PlaneFigure> expected = List.of(segment(1, 2, 9, 2), polygon(1, 4, 5, 4, 5, 7));
        Seen seen = seen(expected, List.of(polygon(5, 7, 5, 4, 1, 4), segment(9, 2, 1, 2)));
        assertEquals(0, Seen.count(seen.difference(), Ink.MISSING));
        assertEquals(
                "segments whose start and end are exchanged: 1; the first must go from (1, 2) to"
                        + " (9, 2); polygons that go round the other way: 1",
                seen.differenceText("en"));
        assertTrue(seen.differenceText("ru").startsWith("отрезков, у которых начало и конец"));
    }

    @Test
    void aMissingFigureIsDashedAndAnExtraOneWholeEachAtItsPlace() {
        List<PlaneFigure> expected = List.of(segment(1, 2, 9, 2));
        List<PlaneFigure> actual = List.of(segment(1, 6, 9, 6));
        Seen seen = seen(expected, actual);
        PlaneToPixels view = view(expected, actual);
        int missing = Seen.count(seen.difference(), Ink.MISSING, around(view, 1, 2, 9, 2));
        int extra = Seen.count(seen.difference(), Ink.EXTRA, around(view, 1, 6, 9, 6));
        assertTrue(missing > 100, "missing: " + missing);
        assertTrue(extra > missing * 1.3, "dashes have gaps: " + missing + ", whole: " + extra);
        assertEquals(0, Seen.count(seen.difference(), Ink.MISSING, around(view, 1, 6, 9, 6)));
        assertEquals(0, Seen.count(seen.difference(), Ink.EXTRA, around(view, 1, 2, 9, 2)));
        assertTrue(Seen.count(seen.expected(), Ink.EXPECTED, around(view, 1, 2, 9, 2)) > 100);
        assertTrue(Seen.count(seen.actual(), Ink.ACTUAL, around(view, 1, 6, 9, 6)) > 100);
        assertEquals(0, Seen.count(seen.expected(), Ink.ACTUAL));
        assertEquals(0, Seen.count(seen.actual(), Ink.EXPECTED));
    }

    @Test
    void marksOfMissingAndExtraPartsDifferInForm() {
        List<PlaneFigure> expected = List.of(segment(5, 1, 5, 7));
        List<PlaneFigure> actual = List.of(segment(8, 1, 8, 7));
        Seen seen = seen(expected, actual);
        Point2D minus = view(expected, actual).place(new CasePoint(5, 4));
        Point2D plus = view(expected, actual).place(new CasePoint(8, 4));
        var above = new Rectangle2D.Double(-1, -5, 2, 3);
        assertEquals(0, Seen.count(seen.difference(), Ink.MISSING, at(above, minus)));
        assertTrue(Seen.count(seen.difference(), Ink.EXTRA, at(above, plus)) > 0);
    }

    @Test
    void theRightPartOfASegmentIsDark() {
        List<PlaneFigure> expected = List.of(segment(1, 4, 5, 4));
        List<PlaneFigure> actual = List.of(segment(1, 4, 9, 4));
        Seen seen = seen(expected, actual);
        PlaneToPixels view = view(expected, actual);
        Rectangle2D right = around(view, 1, 4, 4.5, 4);
        Rectangle2D beyond = around(view, 5.5, 4, 9, 4);
        assertTrue(Seen.count(seen.difference(), Ink.EXPECTED, right) > 50);
        assertEquals(0, Seen.count(seen.difference(), Ink.EXTRA, right));
        assertTrue(Seen.count(seen.difference(), Ink.EXTRA, beyond) > 50);
        assertEquals(0, Seen.count(seen.difference(), Ink.MISSING, right));
        assertEquals(0, Seen.count(seen.difference(), Ink.MISSING, beyond));
    }

    @Test
    void aMissingAndAnExtraAreaAreHatched() {
        List<PlaneFigure> expected = List.of(polygon(1, 1, 5, 1, 5, 7, 1, 7));
        List<PlaneFigure> actual = List.of(polygon(5, 1, 9, 1, 9, 7, 5, 7));
        Seen seen = seen(expected, actual);
        PlaneToPixels view = view(expected, actual);
        Rectangle2D left = around(view, 1.5, 1.5, 4.5, 6.5);
        Rectangle2D right = around(view, 5.5, 1.5, 8.5, 6.5);
        assertTrue(Seen.count(seen.difference(), Ink.pale(Ink.MISSING), left) > 1000);
        assertTrue(Seen.count(seen.difference(), Ink.faint(Ink.MISSING), left) > 50);
        assertTrue(Seen.count(seen.difference(), Ink.pale(Ink.EXTRA), right) > 1000);
        assertTrue(
                Seen.count(seen.difference(), Ink.faint(Ink.EXTRA), right)
                        > 1.4 * Seen.count(seen.difference(), Ink.faint(Ink.MISSING), left),
                "a plus has more pixels than a minus");
    }

    @Test
    void aDifferenceSmallerThanADotIsCircledAndItsNumbersAreTold() {
        List<PlaneFigure> expected = List.of(segment(1, 1, 9, 7));
        List<PlaneFigure> actual = List.of(segment(1, 1, 9, Math.nextUp(7.0)));
        Seen seen = seen(expected, actual);
        Point2D end = view(expected, actual).place(new CasePoint(9, 7));
        var ring = new Rectangle2D.Double(-16, -16, 32, 32);
        assertTrue(Seen.count(seen.difference(), Ink.EXTRA, at(ring, end)) > 50);
        assertEquals(
                "figures that agree: 0, missing: 1, extra: 1;"
                        + " the first difference: expected (9, 7), actual (9, 7.000000000000001)",
                seen.differenceText("en"));
        assertEquals(
                "фигур совпало: 0, не хватает: 1, лишних: 1;"
                        + " первое отличие: ожидалось (9; 7), получено (9; 7,000000000000001)",
                seen.differenceText("ru"));
        Seen near = new Seen(PlanePictures.of(WINDOW, expected, actual, 1e-9, YAxis.UP));
        assertEquals(0, Seen.count(near.difference(), Ink.EXTRA), "within the tolerance");
    }

    @Test
    void yGrowsAsTheCaseHasIt() {
        List<PlaneFigure> one = List.of(point(5, 8));
        Seen up = new Seen(PlanePictures.of(WINDOW, one, one, 0, YAxis.UP));
        Seen down = new Seen(PlanePictures.of(WINDOW, one, one, 0, YAxis.DOWN));
        int height = up.expected().getHeight();
        var upper = new Rectangle2D.Double(0, 0, 999, height / 2.0);
        assertTrue(Seen.count(up.expected(), Ink.EXPECTED, upper) > 20);
        assertEquals(0, Seen.count(down.expected(), Ink.EXPECTED, upper));
        assertTrue(up.expectedText("en").contains("y grows upwards"));
        assertTrue(down.expectedText("ru").contains("ось y направлена вниз"));
    }

    @Test
    void aThinBoxHasAScaleForEachAxisAndSaysSo() {
        List<PlaneFigure> thin = List.of(segment(0, 0, 100, 1e-3));
        Seen seen = new Seen(PlanePictures.of(NONE, thin, thin, 0, YAxis.UP));
        assertTrue(seen.expectedText("en").contains("x and y have different scales"));
        assertTrue(seen.expectedText("ru").contains("масштабы по x и y разные"));
        assertFalse(seen(thin, thin).expectedText("en").contains("scales"), "the window is wide");
        PlaneBox box = PlaneBox.around(WINDOW, NONE, NONE);
        var view = new PlaneToPixels(box, true, 0, 0);
        assertEquals(view.x(1) - view.x(0), view.y(0) - view.y(1), 0.5, "one scale");
    }

    @Test
    void whatIsNotFiniteOrFarAwayIsTold() {
        List<PlaneFigure> actual = List.of(point(Double.NaN, 1), point(1e300, 4));
        Seen seen = seen(List.of(point(3, 4)), actual);
        seen.assertComplete("not finite");
        String text = seen.actualText("en");
        assertTrue(text.contains("not drawn because a coordinate is not finite: 1"), text);
        assertTrue(text.contains("not wholly within the picture: 1"), text);
        assertTrue(Seen.count(seen.actual(), Ink.ACTUAL) > 30, "a note and an arrow");
        assertTrue(Seen.count(seen.difference(), Ink.EXTRA) > 30);
    }

    @Test
    void figuresAreToldWithTheirCoordinates() {
        Seen seen = seen(List.of(segment(-1.5, 2, 9, 2)), List.of(polygon(0, 0, 1, 0, 0.5, 1)));
        assertEquals(
                "x from −2.305 to 10.805, y from −0.56 to 8.56; y grows upwards;"
                        + " given figures: 1; window from (0, 0) to (10, 8);"
                        + " expected figures: 1; segment from (−1.5, 2) to (9, 2)",
                seen.expectedText("en"));
        assertTrue(seen.expectedText("ru").endsWith("отрезок от (−1,5; 2) до (9; 2)"));
        assertTrue(
                seen.actualText("ru").endsWith("многоугольник с вершинами (0; 0) (1; 0) (0,5; 1)"));
        assertTrue(seen.differenceText("en").endsWith("missing figure starts at (−1.5, 2)"));
    }

    @Test
    void anyCoordinatesCanBeDrawn() {
        long seed = new Random().nextLong();
        var random = new Random(seed);
        for (int i = 0; i < 60; i++) {
            var numbers = new AnyNumbers(random);
            List<PlaneFigure> expected = figures(numbers, random);
            List<PlaneFigure> actual = new ArrayList<>(expected.subList(0, expected.size() / 2));
            actual.addAll(figures(numbers, random));
            List<PlaneFigure> given = figures(numbers, random);
            YAxis axis = random.nextBoolean() ? YAxis.UP : YAxis.DOWN;
            double tolerance = random.nextBoolean() ? 0 : Double.MAX_VALUE;
            new Seen(PlanePictures.of(given, expected, actual, tolerance, axis))
                    .assertComplete("seed " + seed + ", picture " + i);
        }
    }

    @Test
    @DisplayName("axes of a Russian picture have decimal points, or whole numbers are drawn twice")
    void axesAreLabelledAsTheLanguageDoes() {
        for (double size : new double[] {1, 100}) {
            List<PlaneFigure> right = List.of(segment(0, 0, size, size));
            List<PlaneFigure> wrong = List.of(segment(0, size, size, size));
            for (CasePicture one : PlanePictures.of(List.of(), right, wrong, 0, YAxis.UP))
                assertEquals(
                        size == 100,
                        Arrays.equals(one.png("en"), one.png("ru")),
                        one.kind() + size);
        }
    }

    @Test
    void aCrowdedPictureStaysSmallAndKeepsItsColors() {
        var random = new Random(3);
        var expected = new ArrayList<PlaneFigure>();
        var actual = new ArrayList<PlaneFigure>();
        for (int i = 0; i < 300; i++) {
            double[] n = random.doubles(8, 0, 8).toArray();
            expected.add(segment(n[0], n[1], n[2], n[3]));
            actual.add(i % 3 == 0 ? segment(n[4], n[5], n[6], n[7]) : expected.get(i));
        }
        List<CasePicture> pictures = PlanePictures.of(WINDOW, expected, actual, 0, YAxis.UP);
        for (CasePicture one : pictures)
            assertTrue(one.png().length < 1.25 * PngBytes.MOST, one.kind() + one.png().length);
        BufferedImage difference = new Seen(pictures).difference();
        for (Color ink : List.of(Ink.EXPECTED, Ink.MISSING, Ink.EXTRA))
            assertTrue(Seen.count(difference, ink) > 100, ink::toString);
    }

    @Test
    void figuresOfManyVerticesAreNotComparedInPairs() {
        var round = new double[20_000];
        for (int i = 0; i < round.length; i += 2) {
            round[i] = 5 + 4 * Math.cos(i * 1e-3);
            round[i + 1] = 4 + 3 * Math.sin(i * 1e-3);
        }
        double[] moved = round.clone();
        moved[0] += 1e-6;
        Seen seen = seen(List.of(polygon(round)), List.of(polygon(moved)));
        seen.assertComplete("10,000 vertices");
        assertTrue(Seen.count(seen.difference(), Ink.MISSING) > 20);
        assertTrue(seen.expectedText("en").contains("polygon of 10000 vertices"));
    }

    @Test
    void aNegativeToleranceIsRefused() {
        assertThrows(
                IllegalArgumentException.class,
                () -> PlanePictures.of(NONE, NONE, NONE, -1, YAxis.UP));
    }

    private static List<PlaneFigure> figures(AnyNumbers numbers, Random random) {
        var figures = new ArrayList<PlaneFigure>();
        for (int i = random.nextInt(4); i > 0; i--)
            figures.add(
                    switch (random.nextInt(5)) {
                        case 0 -> point(numbers.next(), numbers.next());
                        case 1 -> polygon(numbers.some(2 * random.nextInt(6)));
                        case 2 -> {
                            double[] n = numbers.some(4);
                            yield window(n[0], n[1], n[2], n[3]);
                        }
                        default -> {
                            double[] n = numbers.some(4);
                            yield segment(n[0], n[1], n[2], n[3]);
                        }
                    });
        return figures;
    }

    private static Seen seen(List<PlaneFigure> expected, List<PlaneFigure> actual) {
        return new Seen(PlanePictures.of(WINDOW, expected, actual, 0, YAxis.UP));
    }

    private static PlaneToPixels view(List<PlaneFigure> expected, List<PlaneFigure> actual) {
        return new PlotAxes(PlaneBox.around(WINDOW, expected, actual), true, "en").view();
    }

    /** The pixels around a part of the plane. */
    private static Rectangle2D around(
            PlaneToPixels view, double x0, double y0, double x1, double y1) {
        var part = new Rectangle2D.Double(view.x(x0), view.y(y0), 0, 0);
        part.add(view.x(x1), view.y(y1));
        return new Rectangle2D.Double(
                part.getX() - 4, part.getY() - 4, part.getWidth() + 8, part.getHeight() + 8);
    }

    private static Rectangle2D at(Rectangle2D part, Point2D place) {
        return new Rectangle2D.Double(
                part.getX() + place.getX(),
                part.getY() + place.getY(),
                part.getWidth(),
                part.getHeight());
    }
}
