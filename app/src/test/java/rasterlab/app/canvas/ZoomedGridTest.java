package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ZoomedGridTest {
    private final ZoomedGrid grid = new ZoomedGrid(100, 50, 20);

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "'a pixel is named by its corner, not its centre', 109.9, 59.9, 0, 0",
        "'the right edge belongs to the left pixel', 110, 50, 1, 0",
        "'negative pixels are rounded towards zero', 89.9, 39.9, -1, -1",
    })
    void findsThePixelUnderAPoint(String mistake, double viewX, double viewY, int x, int y) {
        assertEquals(new Point(x, y), grid.pixelAt(viewX, viewY), mistake);
    }

    @Test
    void zoomKeepsThePointUnderThePointer() {
        var pointer = new Point2D.Double(173, 91);
        ZoomedGrid zoomed = grid.zoomed(1.7, pointer);
        double before = (pointer.x - grid.originX()) / grid.cell();
        double after = (pointer.x - zoomed.originX()) / zoomed.cell();
        assertEquals(before, after, 1e-9);
    }

    @Test
    void zoomStopsAtTheLargestAndSmallestCell() {
        var center = new Point2D.Double();
        assertEquals(ZoomedGrid.LARGEST, grid.zoomed(1e9, center).cell());
        assertEquals(ZoomedGrid.SMALLEST, grid.zoomed(1e-9, center).cell());
        assertThrows(IllegalArgumentException.class, () -> new ZoomedGrid(0, 0, Double.NaN));
    }

    @Test
    void fitsAWholeBoxIntoTheView() {
        var view = new Rectangle(44, 22, 700, 500);
        ZoomedGrid fitted = ZoomedGrid.fitting(new Rectangle(-7, 3, 40, 60), view);
        assertTrue(fitted.viewX(-7.5) >= view.getMinX());
        assertTrue(fitted.viewX(32.5) <= view.getMaxX());
        assertTrue(fitted.viewY(2.5) >= view.getMinY());
        assertTrue(fitted.viewY(62.5) <= view.getMaxY());
    }

    @Test
    void lineBetweenNearPixelsIsWhole() {
        Line2D line = grid.line(-1, 2, 30, 4);
        assertEquals(new Point2D.Double(80, 90), line.getP1());
        assertEquals(new Point2D.Double(700, 130), line.getP2());
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "far line leaves the view, -2147483648, -2147483648, 2147483647, 2147483647",
        "shortened line turns, -2147483648, 0, 2147483647, 1",
        "line that begins in the view loses its beginning, 3, 4, 2147483647, -2147483648",
        "line that ends in the view loses its end, -2147483648, 7, 3, 4",
    })
    void farLineIsShortenedAlongItself(String mistake, int x0, int y0, int x1, int y1) {
        Line2D line = grid.line(x0, y0, x1, y1);
        var whole =
                new Line2D.Double(grid.viewX(x0), grid.viewY(y0), grid.viewX(x1), grid.viewY(y1));
        assertEquals(0, distance(whole, line.getP1()), 1e-3, mistake);
        assertEquals(0, distance(whole, line.getP2()), 1e-3, mistake);
        assertTrue(line.getP1().distance(line.getP2()) <= 2e5 + 1, mistake);
        assertTrue(line.ptSegDist(0, 0) < 1e3, mistake);
        var ends = Set.of(line.getP1(), line.getP2());
        for (Point2D end : List.of(whole.getP1(), whole.getP2()))
            assertEquals(end.distance(0, 0) < 1e3, ends.contains(end), mistake);
    }

    /** How far a point lies beside a line; {@code ptLineDist} loses it in long lines. */
    private static double distance(Line2D line, Point2D point) {
        double dx = line.getX2() - line.getX1();
        double dy = line.getY2() - line.getY1();
        double cross = dx * (point.getY() - line.getY1()) - dy * (point.getX() - line.getX1());
        return cross / Math.hypot(dx, dy);
    }
}
