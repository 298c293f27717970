package rasterlab.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.PixelRecording;

class SkeletonTest {
    @Test
    void recordsWritesInOrder() {
        var recording = new PixelRecording(2);
        recording.plot(3, 4);
        assertEquals(3, recording.x(0));
    }
}
