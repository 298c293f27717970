package rasterlab.engine.texture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Lookups of many places at a time against those of one. */
class RepeatedLevelsTest {
    private static final int PLACES = 4000;

    /** A part of 256 more or less moves a level by one at most, three times over. */
    private static final int BOUND = 3;

    private final Random random = new Random(1983);
    private final float[] s = new float[PLACES];
    private final float[] t = new float[PLACES];
    private final float[] squaredStep = new float[PLACES];
    private final int[] texel = new int[PLACES];

    /** Half of the places are texels' corners or centres. */
    @BeforeEach
    void place() {
        for (int i = 0; i < PLACES; i++) {
            s[i] = i % 2 == 0 ? random.nextInt(257) / 64f - 2 : random.nextFloat() * 8 - 4;
            t[i] = i % 2 == 0 ? random.nextInt(257) / 64f - 2 : random.nextFloat() * 8 - 4;
            squaredStep[i] = (float) Math.exp(random.nextDouble() * 16 - 4);
        }
        squaredStep[0] = 0;
    }

    private TextureSampler sampler(int width, int height) {
        int[] argb = random.ints((long) width * height).toArray();
        return new TextureSampler(Texture.of(width, height, 4, argb), Wrap.REPEAT, Wrap.REPEAT);
    }

    @ParameterizedTest(name = "{0}×{1} texels")
    @CsvSource({"16, 16", "1, 8", "32, 1", "1, 1", "64, 4", "3, 5"})
    void areThoseOfOnePlace(int width, int height) {
        var sampler = sampler(width, height);
        sampler.nearest(PLACES, s, t, texel);
        for (int i = 0; i < PLACES; i++) assertNear(sampler.nearest(s[i], t[i]), i, 0);
        sampler.linear(PLACES, s, t, texel);
        for (int i = 0; i < PLACES; i++) assertNear(sampler.linear(s[i], t[i]), i, BOUND);
        sampler.trilinear(PLACES, s, t, squaredStep, texel);
        for (int i = 0; i < PLACES; i++) {
            double lambda = DetailLevel.quick(squaredStep[i]);
            assertNear(sampler.trilinear(s[i], t[i], lambda), i, BOUND);
        }
    }

    private void assertNear(int expected, int i, int bound) {
        for (int shift = 0; shift < 32; shift += 8)
            assertEquals(
                    expected >>> shift & 255,
                    texel[i] >>> shift & 255,
                    bound,
                    "s = %s, t = %s, squared step %s".formatted(s[i], t[i], squaredStep[i]));
    }
}
