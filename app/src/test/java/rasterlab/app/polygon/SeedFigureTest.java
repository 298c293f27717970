package rasterlab.app.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.SeedFigure;

class SeedFigureTest {
    @ParameterizedTest(name = "a picture of rows ''{0}'' with the pen at {1}, {2} can be made")
    @CsvSource({
        "'... ..', 0, 0, 'row 1 must have 3 characters as row 0, got 2'",
        "'', 0, 0, 'a picture must have at least 1×1 pixel, got none'",
        "'... ...', 3, 0, 'pen must be a pixel of the picture of 3×2, got (3.0, 0.0)'",
        "'... ...', 0, -1, 'pen must be a pixel of the picture of 3×2, got (0.0, -1.0)'",
    })
    @DisplayName("a figure that cannot be drawn is made")
    void refusesWhatCannotBeDrawn(String rows, double x, double y, String message) {
        var seed = new PolygonPoint(0, 0);
        var pen = new PolygonPoint(x, y);
        List<String> each = List.of(rows.split(" "));
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new SeedFigure(each, seed, pen, 4, false));
        assertEquals(message, refusal.getMessage());
    }
}
