package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.Raster;

class DepthRasterTest {
    @Test
    void everyPixelHasADepthAndNothingElseHas() {
        var picture = new Raster(3, 2);
        var thrown =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new DepthRaster(picture, new float[5]));
        assertEquals("depth must hold 6 numbers for 3×2 pixels, got 5", thrown.getMessage());
    }
}
