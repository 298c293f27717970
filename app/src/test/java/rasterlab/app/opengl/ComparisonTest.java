package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.Raster;

class ComparisonTest {
    @Test
    @DisplayName("the largest difference is 0 beside pixels that are off by 2")
    void roundedPixelsCountAmongTheLargest() {
        var left = new Raster(3, 1);
        var right = new Raster(3, 1);
        left.argb()[0] = 0xFF000002;
        right.argb()[0] = 0xFF000000;
        left.argb()[1] = 0xFF100000;
        right.argb()[1] = 0xFF110000;
        assertFound(2, 0, 2, left, right);
        right.argb()[2] = left.argb()[2] ^ 0x000900;
        assertFound(2, 1, 9, left, right);
    }

    private static void assertFound(
            long rounded, long plain, int largest, Raster left, Raster right) {
        Comparison found = Comparison.of(left, right);
        assertEquals(rounded, found.rounded());
        assertEquals(plain, found.plain().plainlyWrongPixels());
        assertEquals(largest, found.largest());
    }
}
