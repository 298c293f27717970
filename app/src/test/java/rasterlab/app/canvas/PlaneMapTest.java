package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PlaneMapTest {
    private static final Rectangle VIEW = new Rectangle(44, 22, 700, 500);
    private static final Rectangle2D WORLD = new Rectangle2D.Double(-3, 2, 10, 1);

    @Test
    void axesPointAsTheirNamesSay() {
        assertTrue(PlaneMap.fitting(WORLD, VIEW, PlaneAxes.RASTER).scaleY() > 0, "raster");
        assertTrue(PlaneMap.fitting(WORLD, VIEW, PlaneAxes.GEOMETRY).scaleY() < 0, "geometry");
        PlaneMap geometry = PlaneMap.fitting(WORLD, VIEW, PlaneAxes.GEOMETRY);
        assertEquals(geometry.scaleX(), -geometry.scaleY());
        PlaneMap graph = PlaneMap.fitting(WORLD, VIEW, PlaneAxes.GRAPH);
        assertTrue(-graph.scaleY() > 5 * graph.scaleX(), graph.toString());
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "box is cut, -3, 2, 10, 1",
        "point has no scale, 5, 5, 0, 0",
        "line has no height, 0, 7, 4, 0",
        "upright line has no width, 0, 7, 0, 4",
        "huge box overflows, -1e200, -1e200, 2e200, 2e200",
        "tiny box vanishes, 0, 0, 3e-90, 2e-90",
        "far box is lost, 1e9, 5e9, 4, 3",
    })
    void fittedBoxIsInSight(String mistake, double x, double y, double width, double height) {
        var box = new Rectangle2D.Double(x, y, width, height);
        for (PlaneAxes axes : new PlaneAxes[] {PlaneAxes.RASTER, PlaneAxes.GRAPH}) {
            PlaneMap map = PlaneMap.fitting(box, VIEW, axes);
            for (double cornerX : new double[] {box.getMinX(), box.getMaxX()})
                for (double cornerY : new double[] {box.getMinY(), box.getMaxY()})
                    assertTrue(
                            VIEW.contains(map.viewX(cornerX), map.viewY(cornerY)),
                            mistake + ": " + map);
        }
    }

    @Test
    void worldIsTheReverseOfView() {
        PlaneMap map = PlaneMap.fitting(WORLD, VIEW, PlaneAxes.GRAPH);
        assertEquals(1.25, map.worldX(map.viewX(1.25)), 1e-9);
        assertEquals(2.5, map.worldY(map.viewY(2.5)), 1e-9);
    }

    @Test
    void zoomKeepsThePointUnderThePointerAndStopsAtItsRange() {
        PlaneMap map = PlaneMap.fitting(WORLD, VIEW, PlaneAxes.GRAPH);
        var pointer = new Point2D.Double(173, 91);
        PlaneMap zoomed = map.zoomed(1.7, pointer);
        assertEquals(map.worldX(173), zoomed.worldX(173), 1e-9);
        assertEquals(map.worldY(91), zoomed.worldY(91), 1e-9);
        assertEquals(1.7 * map.scaleX(), zoomed.scaleX(), 1e-9);
        for (double factor : new double[] {1e300, 1e-300})
            assertTrue(map.zoomed(factor, pointer).zoomed(factor, pointer).scaleX() > 0);
        assertThrows(IllegalArgumentException.class, () -> new PlaneMap(0, 0, Double.NaN, 1));
        assertThrows(IllegalArgumentException.class, () -> new PlaneMap(0, 0, -1, 1));
    }

    @ParameterizedTest(name = "a dragged number has noise or too few digits at {0} per unit")
    @CsvSource({
        "1, 3.46, 3",
        "2, 3.46, 3.5",
        "25, 3.4567, 3.46",
        "0.3, 34.2, 34",
        "0.05, 34.2, 30"
    })
    void draggedNumbersAreAsLongAsTheScreenCanTell(double scale, double world, double expected) {
        var map = new PlaneMap(100, 50, scale, -scale);
        double pointed = map.pointedX(map.viewX(world));
        assertEquals(expected, pointed, 1 / scale);
        assertTrue(Double.toString(pointed).length() <= 5, "" + pointed);
    }
}
