package rasterlab.engine.texture.filter;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import rasterlab.engine.study.Deviation;

class TextureFilterTest {
    private static final FilterTopic TOPIC = new FilterTopic();

    @Property(tries = 200)
    void summedAreaIsExact(@ForAll long seed) {
        var random = new Random(seed);
        int width = 1 + random.nextInt(9);
        int height = 1 + random.nextInt(9);
        double[] pixel = {
            random.nextDouble(-3, 3),
            random.nextDouble(-3, 3),
            random.nextDouble(-3, 3),
            0,
            0,
            random.nextDouble(-3, 3)
        };
        var pixels =
                new FilteredPixels(
                        width, height, random.ints((long) width * height).toArray(), pixel);
        Deviation deviation =
                TOPIC.compare(
                        pixels,
                        TOPIC.exact(pixels, 1),
                        TOPIC.record(TOPIC.method("summed-area").implementation(), pixels, 1));
        assertTrue(TOPIC.correct(deviation), deviation::toString);
    }

    @Test
    void turnedFootprintCountsEachTexelByItsArea() {
        int[] argb = {0xFFFF0000, 0xFF0000FF, 0xFF0000FF, 0xFFFF0000};
        double[] diamond = {0.5, 0.5, 0.25, 0.25, -0.25, 0.25};
        var pixels = new FilteredPixels(2, 2, argb, diamond);
        assertArrayEquals(new double[] {255, 127.5, 0, 127.5}, TOPIC.exact(pixels, 1), 1e-9);
        double[] aside = {0.25, 0.25, 0.25, 0.25, -0.25, 0.25};
        var corner = new FilteredPixels(2, 2, argb, aside);
        assertArrayEquals(new double[] {255, 255, 0, 0}, TOPIC.exact(corner, 1), 1e-9);
    }

    @Test
    void withoutLevelsFineStripesFlickerAsTheyMove() {
        assertTrue(contrast("nearest") == 255, "nearest " + contrast("nearest"));
        assertTrue(contrast("trilinear") < 40, "trilinear " + contrast("trilinear"));
    }

    /** The largest difference of two pixels of the hazard "aliasing". */
    private static double contrast(String method) {
        var hazard = TOPIC.hazards().stream().filter(h -> h.name().equals("aliasing")).findFirst();
        double[] levels =
                TOPIC.record(
                        TOPIC.method(method).implementation(), hazard.orElseThrow().input(), 99);
        double least = 255;
        double most = 0;
        for (int i = 1; i < levels.length; i += 4) {
            least = Math.min(least, levels[i]);
            most = Math.max(most, levels[i]);
        }
        return most - least;
    }

    @Test
    void refusesAFootprintOfEndlessSize() {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () ->
                                new FilteredPixels(
                                        1, 1, new int[1], new double[] {0, 0, 1e9, 0, 0, 0}));
        assertEquals("pixels[0][2] must stay within 4096 texels, got 1.0E9", refusal.getMessage());
    }
}
