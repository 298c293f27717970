package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Dimension;
import java.awt.Rectangle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WindowPlaceTest {
    @ParameterizedTest(name = "type of {0} on a screen of {1}×{2} makes the window too large")
    @CsvSource({
        "1, 1600, 1000, 900, 600, 1280, 800",
        "1.25, 1600, 1000, 1125, 750, 1600, 1000",
        "2, 1600, 1000, 1280, 800, 1600, 1000",
        "2, 1280, 770, 1280, 770, 1280, 770",
        "1, 800, 560, 800, 560, 800, 560",
    })
    void windowIsNoLargerThanItsScreen(
            float scale, int wide, int high, int leastWide, int leastHigh, int width, int height) {
        var place = new WindowPlace(new Rectangle(0, 30, wide, high), scale);
        assertEquals(new Dimension(leastWide, leastHigh), place.least());
        assertEquals(new Dimension(width, height), place.first());
    }

    @ParameterizedTest(name = "a window of {1}×{2} at {0}, {0} comes back elsewhere")
    @CsvSource({
        "700, 900, 600, 320, 230, 1280, 800",
        "700, 1280, 800, 700, 700, 1280, 800",
        "-40, 1000, 700, 0, 30, 1280, 800",
    })
    void windowComesBackWhereItFits(
            int at, int width, int height, int x, int y, int wide, int high) {
        var place = new WindowPlace(new Rectangle(0, 30, 1600, 1000), 2);
        assertEquals(
                new Rectangle(x, y, wide, high), place.again(new Rectangle(at, at, width, height)));
    }
}
