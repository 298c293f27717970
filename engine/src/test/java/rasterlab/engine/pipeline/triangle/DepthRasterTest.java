package rasterlab.engine.pipeline.triangle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.Raster;

class DepthRasterTest {
    @Test
    void depthsServeAnotherPicture() {
        var depths = new DepthRaster(3, 2);
        var picture = new Raster(3, 2);
        assertSame(picture, depths.of(picture).raster());
        assertSame(depths.depth(), depths.of(picture).depth());
    }

    @Test
    void depthsServeNoPictureOfAnotherSize() {
        var depths = new DepthRaster(3, 2);
        var thrown =
                assertThrows(IllegalArgumentException.class, () -> depths.of(new Raster(2, 3)));
        assertEquals("picture must be of 3×2 pixels, got 2×3", thrown.getMessage());
    }
}
