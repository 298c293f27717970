package rasterlab.engine.raster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.api.Test;

class NearestPixelTest {
    private static final long SEED = 5;

    @Test
    void findsWhatTryingEveryPixelFinds() {
        var random = new Random(SEED);
        for (int round = 0; round < 300; round++) {
            var pixels = new PixelRecording(100);
            int count = random.nextInt(1, 60);
            for (int i = 0; i < count; i++)
                pixels.plot(random.nextInt(-50, 50), random.nextInt(-9, 9));
            var nearest = new NearestPixel(pixels);
            for (int i = 0; i < 30; i++) {
                int x = random.nextInt(-80, 80);
                int y = random.nextInt(-80, 80);
                String where = "(" + x + ", " + y + "), round " + round + ", seed " + SEED;
                assertEquals(byTrying(pixels, x, y), nearest.distance(x, y), where);
            }
        }
    }

    @Test
    void measuresAcrossTheWholeRangeOfAnInt() {
        var pixels = new PixelRecording(1);
        pixels.plot(Integer.MAX_VALUE, 0);
        long distance = new NearestPixel(pixels).distance(Integer.MIN_VALUE, 0);
        assertEquals((1L << 32) - 1, distance);
    }

    @Test
    void refusesAnEmptyRecording() {
        var empty = new PixelRecording(1);
        assertThrows(IllegalArgumentException.class, () -> new NearestPixel(empty));
    }

    private static long byTrying(PixelRecording pixels, int x, int y) {
        long best = Long.MAX_VALUE;
        for (int i = 0; i < pixels.size(); i++)
            best = Math.min(best, Math.max(Math.abs(x - pixels.x(i)), Math.abs(y - pixels.y(i))));
        return best;
    }
}
