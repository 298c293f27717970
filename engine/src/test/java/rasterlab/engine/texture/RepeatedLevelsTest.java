package rasterlab.engine.texture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.EightLanes;

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
        sampler.nearest(Lanes.ONE, PLACES, s, t, texel);
        for (int i = 0; i < PLACES; i++) assertNear(sampler.nearest(s[i], t[i]), i, 0);
        sampler.linear(Lanes.ONE, PLACES, s, t, texel);
        for (int i = 0; i < PLACES; i++) assertNear(sampler.linear(s[i], t[i]), i, BOUND);
        sampler.trilinear(Lanes.ONE, PLACES, s, t, squaredStep, texel);
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

    /** Few places, whole eights and more than a block; some of the steps grow slowly, some not. */
    @ParameterizedTest(name = "{0} places are others in eight lanes")
    @CsvSource({"1", "7", "8", "9", "255", "256", "260", "511"})
    void areTheSameInEightLanes(int count) {
        EightLanes.assumeThere();
        int[] expected = new int[count];
        for (int round = 0; round < 20; round++) {
            place();
            if (round % 2 == 0) Arrays.sort(squaredStep);
            s[0] = Float.NaN;
            t[count - 1] = round == 0 ? -1e-12f : Float.NEGATIVE_INFINITY;
            var sampler = sampler(1 << random.nextInt(7), 1 << random.nextInt(7));
            float[] places = Arrays.copyOf(s, count);
            float[] heights = Arrays.copyOf(t, count);
            int from = random.nextInt(PLACES - count);
            float[] steps = Arrays.copyOfRange(squaredStep, from, from + count);
            sampler.nearest(Lanes.ONE, count, places, heights, expected);
            sampler.nearest(Lanes.EIGHT, count, places, heights, texel);
            assertSame(expected, "nearest, round " + round);
            sampler.linear(Lanes.ONE, count, places, heights, expected);
            sampler.linear(Lanes.EIGHT, count, places, heights, texel);
            assertSame(expected, "linear, round " + round);
            sampler.trilinear(Lanes.ONE, count, places, heights, steps, expected);
            sampler.trilinear(Lanes.EIGHT, count, places, heights, steps, texel);
            assertSame(expected, "trilinear, round " + round);
        }
    }

    private void assertSame(int[] expected, String what) {
        assertArrayEquals(expected, Arrays.copyOf(texel, expected.length), what + " of seed 1983");
    }
}
