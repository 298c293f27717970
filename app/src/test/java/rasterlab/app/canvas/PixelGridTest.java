package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PixelGridTest {
    private final PixelGrid grid = new PixelGrid(100, 50, 20);

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
        PixelGrid zoomed = grid.zoomed(1.7, pointer);
        double before = (pointer.x - grid.originX()) / grid.cell();
        double after = (pointer.x - zoomed.originX()) / zoomed.cell();
        assertEquals(before, after, 1e-9);
    }

    @Test
    void zoomStopsAtTheLargestAndSmallestCell() {
        var centre = new Point2D.Double();
        assertEquals(PixelGrid.LARGEST, grid.zoomed(1e9, centre).cell());
        assertEquals(PixelGrid.SMALLEST, grid.zoomed(1e-9, centre).cell());
        assertThrows(IllegalArgumentException.class, () -> new PixelGrid(0, 0, Double.NaN));
    }

    @Test
    void fitsAWholeBoxIntoTheView() {
        var view = new Rectangle(44, 22, 700, 500);
        PixelGrid fitted = PixelGrid.fitting(new Rectangle(-7, 3, 40, 60), view);
        assertTrue(fitted.viewX(-7.5) >= view.getMinX());
        assertTrue(fitted.viewX(32.5) <= view.getMaxX());
        assertTrue(fitted.viewY(2.5) >= view.getMinY());
        assertTrue(fitted.viewY(62.5) <= view.getMaxY());
    }
}
