package rasterlab.engine.texture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.engine.texture.TextureTest.gray;
import static rasterlab.engine.texture.TextureTest.grays;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class TextureSamplerTest {
    /** Four texels with the levels 0, 10, 20, 30 from left to right. */
    private static final Texture STAIRS = grays(4, 1, 0, 10, 20, 30);

    @ParameterizedTest(name = "{0} finds the wrong texel at s = {1}")
    @CsvSource({
        "REPEAT, 0.3, 10",
        "REPEAT, 1.0, 0",
        "REPEAT, 1.3, 10",
        "REPEAT, -0.1, 30",
        "REPEAT, -1e-20, 0",
        "REPEAT, 1e30, 0",
        "MIRRORED, 1.1, 30",
        "MIRRORED, 1.9, 0",
        "MIRRORED, 2.1, 0",
        "MIRRORED, -0.3, 10",
        "CLAMP_TO_EDGE, 1.0, 30",
        "CLAMP_TO_EDGE, 7, 30",
        "CLAMP_TO_EDGE, -7, 0",
        "CLAMP, 1.0, 30",
        "CLAMP, -2, 0",
    })
    void nearest(Wrap wrap, double s, int level) {
        assertEquals(gray(level), new TextureSampler(STAIRS, wrap, wrap).nearest(s, 0.5));
    }

    @ParameterizedTest(name = "{0} mixes the wrong texels at s = {1}")
    @CsvSource({
        "REPEAT, 0.25, 5",
        "REPEAT, 0.375, 10",
        "REPEAT, 0, 15",
        "MIRRORED, 0, 0",
        "MIRRORED, 1, 30",
        "MIRRORED, 1.25, 25",
        "CLAMP_TO_EDGE, 1, 30",
        "CLAMP_TO_EDGE, 0.9, 30",
        "CLAMP_TO_EDGE, -3, 0",
    })
    void linear(Wrap wrap, double s, int level) {
        assertEquals(
                gray(level),
                new TextureSampler(STAIRS, wrap, Wrap.REPEAT).linear(s, 0.5),
                () -> "s = " + s);
    }

    @Test
    void clampMixesWithTheTransparentBorder() {
        var sampler = new TextureSampler(grays(1, 1, 200), Wrap.CLAMP, Wrap.CLAMP_TO_EDGE);
        assertEquals(0x80646464, sampler.linear(1, 0.5));
        assertEquals(gray(200), sampler.linear(0.5, 0.5));
    }

    @Property(tries = 500)
    void linearIsWithinTwoLevelsOfTheExactMean(@ForAll long seed) {
        var random = new Random(seed);
        int width = 1 + random.nextInt(6);
        int height = 1 + random.nextInt(6);
        int[] argb = random.ints((long) width * height).toArray();
        var texture = Texture.of(width, height, 4, argb);
        var sampler = new TextureSampler(texture, Wrap.REPEAT, Wrap.REPEAT);
        double s = random.nextDouble(-2, 2);
        double t = random.nextDouble(-2, 2);
        int mixed = sampler.linear(s, t);
        for (int shift = 0; shift < 32; shift += 8)
            assertEquals(
                    exactLinear(texture.level(0), s, t, shift), mixed >>> shift & 255, 2, "" + s);
    }

    private static double exactLinear(TextureLevel level, double s, double t, int shift) {
        double sum = 0;
        for (int j = 0; j < level.height(); j++)
            for (int i = 0; i < level.width(); i++)
                sum +=
                        hat(s * level.width() - i - 0.5, level.width())
                                * hat(t * level.height() - j - 0.5, level.height())
                                * (level.texel(i, j) >>> shift & 255);
        return sum;
    }

    /** The share of a texel and all its repetitions, {@code away} from its centre. */
    private static double hat(double away, int period) {
        double sum = 0;
        for (int turn = -20; turn <= 20; turn++)
            sum += Math.max(0, 1 - Math.abs(away + (double) turn * period));
        return sum;
    }

    @Test
    void trilinearPassesThroughItsLevelsAndMixesBetweenThem() {
        Texture texture = grays(4, 1, 0, 0, 200, 200);
        var sampler = new TextureSampler(texture, Wrap.CLAMP_TO_EDGE, Wrap.CLAMP_TO_EDGE);
        assertEquals(gray(0), sampler.trilinear(0.2, 0.5, -3));
        assertEquals(gray(0), sampler.trilinear(0.25, 0.5, 1));
        assertEquals(gray(50), sampler.trilinear(0.25, 0.5, 1.5));
        assertEquals(gray(100), sampler.trilinear(0.25, 0.5, 2));
        assertEquals(gray(100), sampler.trilinear(0.25, 0.5, 99));
        assertEquals(gray(200), sampler.nearestLevel(0.9, 0.5, 1.4));
        assertEquals(gray(100), sampler.nearestLevel(0.9, 0.5, 1.6));
    }

    @ParameterizedTest(name = "{0} leaves the picture on NaN")
    @EnumSource
    void nothingLeavesThePicture(Wrap wrap) {
        var sampler = new TextureSampler(grays(3, 5, new int[15]), wrap, wrap);
        for (double wild : new double[] {Double.NaN, 1 / 0.0, -1 / 0.0, 1e300, -1e300, 0x1p53})
            for (double tame : new double[] {0, 0.5, Math.nextDown(1.0), 1, -1e-300}) {
                assertEquals(0, sampler.nearest(wild, tame) & 0xFFFFFF);
                assertEquals(0, sampler.linear(tame, wild) & 0xFFFFFF);
                assertEquals(0, sampler.trilinear(wild, wild, wild) & 0xFFFFFF);
            }
    }

    @Test
    void levelIsTheLogarithmOfTexelsPerPixel() {
        double step = DetailLevel.squaredStep(4 / 256.0, 0, 0, 2 / 256.0, 256, 256);
        assertEquals(2, DetailLevel.of(step), 1e-12);
        assertEquals(2, DetailLevel.quick(step), 0.005);
        assertEquals(
                0.5, DetailLevel.of(DetailLevel.squaredStep(0, 0, 1 / 8.0, 1 / 4.0, 8, 4)), 1e-12);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 0.3, 1, 1.5, 7, 1e5, 1e12})
    void quickLevelIsWithinItsPromise(double from) {
        for (double square = from; square < 2 * from; square += from / 50)
            assertTrue(Math.abs(DetailLevel.quick(square) - DetailLevel.of(square)) < 0.005);
    }

    /** Level 0 has 0, 10, 20, 30, level 1 has 5 and 25, level 2 has 15. */
    @ParameterizedTest(name = "λ = {0} at s = {1}: {2} in the level, {3} between levels")
    @CsvSource({
        "0, 0.5, 15, 20",
        "0.25, 0.3, 7, 9",
        "0.75, 0.25, 5, 6",
        "1, 0.25, 5, 5",
        "1.5, 0.8, 15, 20",
        "9, 0.25, 15, 15",
    })
    void levelsAreMixedOrChosen(double lambda, double s, int inLevel, int between) {
        var sampler = new TextureSampler(STAIRS, Wrap.CLAMP_TO_EDGE, Wrap.CLAMP_TO_EDGE);
        assertEquals(gray(inLevel), sampler.linearLevel(s, 0.5, lambda));
        assertEquals(gray(between), sampler.nearestBetween(s, 0.5, lambda));
    }
}
