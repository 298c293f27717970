package rasterlab.engine.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.raster.Raster;

class OutlineStrokeTest {
    @ParameterizedTest(name = "the edge ({0}, {1})→({2}, {3}) is turned by cutting it")
    @CsvSource({
        "3, 5, 60, 41",
        "-300, -17, 400, 58",
        "-20000, -3000, 30001, 4567",
        "90000, 41000, -70003, -31900"
    })
    void anEdgeThatLeavesThePictureLightsThePixelsOfTheWholeEdge(int x0, int y0, int x1, int y1) {
        var picture = new Raster(64, 64);
        new OutlineStroke(picture, -1).edge(x0, y0, x1, y1);
        var expected = new Raster(64, 64);
        var walk = new BresenhamLine().walk(x0, y0, x1, y1, PixelWindow.of(expected));
        while (walk.advance()) expected.argb()[64 * walk.y() + walk.x()] = -1;
        for (int cell = 0; cell < 64 * 64; cell++)
            assertEquals(expected.argb()[cell], picture.argb()[cell], cell % 64 + ", " + cell / 64);
    }

    @ParameterizedTest(name = "the edge to x = {0} overflows an int")
    @CsvSource({"1e12", "-1e300"})
    void anEdgeBeyondTheRangeOfIntIsStillSeen(double far) {
        var picture = new Raster(9, 9);
        new OutlineStroke(picture, -1).edge(4, 4, far, 4);
        assertEquals(-1, picture.argb(far > 0 ? 8 : 0, 4));
        assertEquals(0, picture.argb(far > 0 ? 0 : 8, 4));
    }
}
