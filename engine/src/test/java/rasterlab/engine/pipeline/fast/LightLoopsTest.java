package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.EightLanes;

/** The light's loops of eight lanes beside the plain ones, bit for bit. */
class LightLoopsTest {
    private static final float[] TO_LIGHT = {0.6f, -0.48f, 0.64f};

    private LightLoops eight;
    private final LightLoops one = LightLoops.of(Lanes.ONE);
    private Random random;
    private int seed;

    @BeforeEach
    void needEight(RepetitionInfo repetition) {
        EightLanes.assumeThere();
        eight = LightLoops.of(Lanes.EIGHT);
        seed = repetition.getCurrentRepetition();
        random = new Random(seed);
    }

    /**
     * Places and normals of all lengths; some normals away from the light, some at right angles.
     */
    @RepeatedTest(40)
    void findTheSameCosines() {
        int n = 1 + random.nextInt(40);
        float[][] expected = new float[8][n + 8];
        for (int i = 0; i < n; i++) {
            float far = (float) Math.exp(random.nextDouble() * 20 - 10);
            for (int k = 0; k < 3; k++) expected[k][i] = (random.nextFloat() - 0.5f) * far;
            for (int k = 3; k < 6; k++) expected[k][i] = (random.nextFloat() - 0.5f) / far;
        }
        expected[3][0] = 0.8f;
        expected[4][0] = 1;
        expected[5][0] = 0;
        float[][] actual = new float[8][];
        for (int k = 0; k < 8; k++) actual[k] = expected[k].clone();
        cosines(one, n, expected);
        cosines(eight, n, actual);
        for (int k = 3; k < 5; k++) assertSame(n, expected[k], actual[k]);
        one.channel(n, 0.2f, 0.7f, expected[3], expected[4], expected[0]);
        eight.channel(n, 0.2f, 0.7f, actual[3], actual[4], actual[0]);
        assertSame(n, expected[0], actual[0]);
    }

    private static void cosines(LightLoops loops, int n, float[][] v) {
        loops.cosines(n, TO_LIGHT, v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]);
    }

    private void assertSame(int n, float[] expected, float[] actual) {
        for (int i = 0; i < n; i++)
            assertEquals(
                    Float.floatToRawIntBits(expected[i]),
                    Float.floatToRawIntBits(actual[i]),
                    "seed %d, number %d of %d: %s, got %s"
                            .formatted(seed, i, n, expected[i], actual[i]));
    }
}
