package rasterlab.engine.raster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class RasterTest {
    @Test
    @DisplayName("pixels are stored by columns")
    void cellIsRowTimesWidthPlusColumn() {
        var raster = new Raster(3, 2);
        raster.argb()[4] = 0xFF123456;
        assertEquals(0xFF123456, raster.argb(1, 1));
        assertEquals(0xFF123456, raster.image().getRGB(1, 1));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refusesSize(int width, int height) {
        var refusal = assertThrows(IllegalArgumentException.class, () -> new Raster(width, height));
        assertEquals(
                "picture size must be from 1×1 to 8192×8192 pixels, got " + width + "×" + height,
                refusal.getMessage());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("no column is accepted", 0, 5),
                argumentSet("no row is accepted", 5, 0),
                argumentSet("negative width is accepted", -1, 5),
                argumentSet("too many columns are accepted", 8193, 1),
                argumentSet("too many rows are accepted", 1, 8193));
    }

    @Test
    @DisplayName("a pixel beyond the right edge is read from the next row")
    void namesThePixelOutside() {
        var raster = new Raster(3, 2);
        var refusal = assertThrows(IndexOutOfBoundsException.class, () -> raster.argb(3, 0));
        assertEquals("pixel (3, 0) is outside a picture of 3×2", refusal.getMessage());
    }
}
