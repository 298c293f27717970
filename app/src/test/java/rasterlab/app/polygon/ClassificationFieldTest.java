package rasterlab.app.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.outcome.PolygonTopics;
import rasterlab.engine.polygon.ExactMembership;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.Points;

class ClassificationFieldTest {
    private static final Rectangle VIEW = new Rectangle(0, 0, 400, 300);
    private static final Points TRIANGLE = Points.of(2, 1, 10, 1, 2, 7);

    private static PlaneMap map(double x, double y, double width, double height) {
        return PlaneMap.fitting(
                new Rectangle2D.Double(x, y, width, height), VIEW, PlaneAxes.GEOMETRY);
    }

    private static ClassificationField field(PlaneMap map, double least, Points corners, String m) {
        return ClassificationField.of(
                map,
                VIEW,
                least,
                new PolygonTopics().judge(PolygonMode.TRIANGLE, m, corners),
                new ExactMembership(corners),
                () -> false);
    }

    @Test
    void pointsCoverTheViewAndLieOnAPowerOfTwo() {
        PlaneMap map = map(0, 0, 12, 8);
        ClassificationField field = field(map, 0, TRIANGLE, "robust");
        assertEquals(field.step(), Math.scalb(1, Math.getExponent(field.step())));
        assertTrue(field.step() * map.scaleX() > 4 && field.step() * map.scaleX() <= 8);
        assertTrue(map.viewX(field.x(0)) <= VIEW.getMinX());
        assertTrue(map.viewX(field.x(field.columns() - 1)) >= VIEW.getMaxX());
        assertTrue(map.viewY(field.y(0)) >= VIEW.getMaxY());
        assertTrue(map.viewY(field.y(field.rows() - 1)) <= VIEW.getMinY());
    }

    @Test
    void boundaryFailuresOfTheSignMethodAreSeen() {
        long wrong = field(map(0, 0, 12, 8), 0, TRIANGLE, "sign-double").differing();
        assertTrue(wrong > 50, wrong + " points differ");
        assertEquals(0, field(map(0, 0, 12, 8), 0, TRIANGLE, "robust").differing());
    }

    @Test
    void overflowFillsThePlaneWithWrongAnswers() {
        Points large = Points.of(-60000, -60000, 62000, -58000, 1000, 64000);
        PlaneMap map = map(-70000, -70000, 140000, 140000);
        long wrong = field(map, 1, large, "sign-int").differing();
        assertTrue(wrong > 500, wrong + " points differ");
        assertEquals(0, field(map, 1, large, "half-plane").differing());
    }

    @Test
    void wholeNumbersAreAtLeastOneApart() {
        ClassificationField field = field(map(0, 0, 12, 8), 1, TRIANGLE, "sign-int");
        assertEquals(1, field.step());
        assertFalse(field.refused(field.columns() / 2, field.rows() / 2));
    }

    @Test
    void fractionsAreRefusedByWholeNumbersAndNotCalledWrong() {
        ClassificationField field = field(map(0, 0, 3, 3), 0, TRIANGLE, "sign-int");
        long refused = 0;
        for (int row = 0; row < field.rows(); row++)
            for (int column = 0; column < field.columns(); column++)
                if (field.refused(column, row)) {
                    refused++;
                    assertFalse(field.differ(column, row));
                }
        assertTrue(refused > 100, refused + " are refused");
    }

    @Test
    void newerFrameStopsIt() {
        Membership.PointClassifier judge = new ExactMembership(TRIANGLE);
        assertThrows(
                CancellationException.class,
                () -> ClassificationField.of(map(0, 0, 12, 8), VIEW, 0, judge, judge, () -> true));
    }

    @Test
    void pointsThatAMethodRefusesAreNotCounted() {
        ClassificationField whole = field(map(0, 0, 12, 8), 1, TRIANGLE, "sign-int");
        assertEquals((long) whole.columns() * whole.rows(), whole.judged());
        ClassificationField between = field(map(0, 0, 12, 8), 0, TRIANGLE, "sign-int");
        assertTrue(between.judged() > 0, "no point is judged");
        assertTrue(between.judged() < (long) between.columns() * between.rows());
    }
}
