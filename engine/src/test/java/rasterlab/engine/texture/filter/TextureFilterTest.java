package rasterlab.engine.texture.filter;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.texture.TexelShare;

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

    /** Colours are mixed in 256ths, in up to three rounds that round by half a level each. */
    @Property(tries = 500)
    void texelsOfAColorMixToIt(@ForAll long seed) {
        var random = new Random(seed);
        int width = 1 + random.nextInt(40);
        int height = 1 + random.nextInt(40);
        double[] pixel = random.doubles(6, -1, 1).toArray();
        int[] argb = random.ints((long) width * height).toArray();
        var pixels = new FilteredPixels(width, height, argb, pixel);
        for (String name : List.of("nearest", "linear", "mipmap-nearest", "trilinear")) {
            var method = (SteppedFilter) TOPIC.method(name).implementation();
            double[] levels = TOPIC.record(method, pixels, 1);
            var mixed = new double[4];
            double whole = 0;
            for (TexelShare texel : method.texels(pixels).get(0)) {
                whole += texel.share();
                for (int c = 0; c < 4; c++)
                    mixed[c] += texel.share() * (texel.argb() >>> 24 - 8 * c & 255);
            }
            assertEquals(1, whole, 1e-12, name);
            assertArrayEquals(levels, mixed, 2, name + ", seed " + seed);
        }
    }

    @Test
    void trilinearLooksUpEightTexels() {
        var pixels = new FilteredPixels(8, 8, new int[64], new double[] {0.3, 0.4, 0.2, 0, 0, 0.2});
        assertEquals(Map.of("texels", 8L, "mixes", 7L), counts("trilinear", pixels));
        assertEquals(Map.of("texels", 4L, "mixes", 3L), counts("linear", pixels));
        assertEquals(Map.of("texels", 1L, "mixes", 0L), counts("mipmap-nearest", pixels));
        var enlarged =
                new FilteredPixels(8, 8, new int[64], new double[] {0.3, 0.4, 0.1, 0, 0, 0.1});
        assertEquals(Map.of("texels", 4L, "mixes", 3L), counts("trilinear", enlarged));
    }

    private static Map<String, Long> counts(String method, FilteredPixels pixels) {
        return TOPIC.operations(TOPIC.method(method).implementation(), pixels);
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
