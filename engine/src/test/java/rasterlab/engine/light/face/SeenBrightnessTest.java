package rasterlab.engine.light.face;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.Raster;

class SeenBrightnessTest {
    @Test
    void lineReachesBothEndsAndMixesBetweenCenters() {
        var picture = new Raster(3, 2);
        picture.clear(0xFF000000);
        picture.argb()[1] = 0xFF0000FF;
        picture.argb()[2] = 0xFFFFFFFF;
        double[] along = SeenBrightness.along(picture, 0, 0, 2, 0, 5);
        assertArrayEquals(new double[] {0, 1 / 6.0, 1 / 3.0, 2 / 3.0, 1}, along, 1e-12);
    }

    @Test
    void stepIsOverAndUnderShotAndEvenGroundIsNot() {
        double[] step = new double[40];
        for (int i = 20; i < 40; i++) step[i] = 1;
        double[] reported = SeenBrightness.reported(step, 4);
        assertTrue(reported[19] < -0.3, "left of the step " + reported[19]);
        assertTrue(reported[20] > 1.3, "right of it " + reported[20]);
        assertEquals(0, reported[5]);
        assertEquals(1, reported[35], 1e-12);
    }

    @Test
    void bendIsReportedToo() {
        double[] bend = new double[40];
        for (int i = 20; i < 40; i++) bend[i] = (i - 20) / 20.0;
        double[] reported = SeenBrightness.reported(bend, 4);
        assertTrue(reported[20] < 0, "no dark band at the bend");
        assertEquals(bend[30], reported[30], 1e-12);
    }

    @Test
    void oneSampleIsNoLine() {
        assertThrows(
                IllegalArgumentException.class,
                () -> SeenBrightness.along(new Raster(1, 1), 0, 0, 0, 0, 1));
    }
}
