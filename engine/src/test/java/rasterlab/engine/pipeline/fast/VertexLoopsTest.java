package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.EightLanes;

/** The vertices' loops of eight lanes beside the plain ones, bit for bit. */
class VertexLoopsTest {
    private static final int ROOM = 64;

    private VertexLoops eight;
    private final VertexLoops one = VertexLoops.of(Lanes.ONE);
    private final float[] x = new float[ROOM];
    private final float[] y = new float[ROOM];
    private final float[] z = new float[ROOM];
    private final float[] w = new float[ROOM];
    private Random random;
    private int seed;
    private int n;

    @BeforeEach
    void placeVertices(RepetitionInfo repetition) {
        EightLanes.assumeThere();
        eight = VertexLoops.of(Lanes.EIGHT);
        seed = repetition.getCurrentRepetition();
        random = new Random(seed);
        n = 1 + random.nextInt(ROOM - 8);
        for (int i = 0; i < ROOM; i++) {
            w[i] = (float) Math.exp(random.nextDouble() * 40 - 20);
            x[i] = w[i] * (2 * random.nextFloat() - 1);
            y[i] = w[i] * (2 * random.nextFloat() - 1);
            z[i] = w[i] * (2 * random.nextFloat() - 1);
        }
    }

    /** The vertices lie in the guard's reach, some on the picture's left and right. */
    @RepeatedTest(40)
    void findTheSamePlaces() {
        for (int i = 0; i < n; i++) {
            int reach = random.nextInt(2) * (Subpixels.GUARD - 1) + 1;
            x[i] *= reach;
            y[i] *= reach;
            if (random.nextInt(4) == 0) x[i] = Math.copySign(w[i], x[i]);
        }
        var subpixels = new Subpixels(1 + random.nextInt(8192), 1 + random.nextInt(8192));
        int from = random.nextInt(9);
        long[] expected = new long[from + n + VertexLoops.SPARE];
        long[] actual = expected.clone();
        one.place(n, x, y, w, subpixels, expected, from);
        eight.place(n, x, y, w, subpixels, actual, from);
        Arrays.fill(expected, from + n, expected.length, 0);
        Arrays.fill(actual, from + n, actual.length, 0);
        assertArrayEquals(expected, actual, "seed " + seed);
    }

    @RepeatedTest(40)
    void findTheSameDepths() {
        float[] depth = z.clone();
        float[] nearness = w.clone();
        one.depths(n, z, w);
        eight.depths(n, depth, nearness);
        for (int i = 0; i < n; i++) {
            assertEquals(z[i], depth[i], "depth %d of seed %d".formatted(i, seed));
            assertEquals(w[i], nearness[i], "1/w %d of seed %d".formatted(i, seed));
        }
    }

    @RepeatedTest(40)
    void noticeEachVertexBeyondAPlane() {
        assertTrue(one.allSeen(n, x, y, z, w), "seed " + seed);
        assertTrue(eight.allSeen(n, x, y, z, w), "seed " + seed);
        int beyond = random.nextInt(n);
        float[] of = new float[][] {x, y, z, w}[random.nextInt(4)];
        float past = Math.nextUp(w[beyond]);
        float[] values =
                of == w
                        ? new float[] {-1, 0, ClipCode.SMALLEST_W / 2}
                        : new float[] {past, -past, Float.POSITIVE_INFINITY};
        if (of == w) x[beyond] = y[beyond] = z[beyond] = 0;
        of[beyond] = values[random.nextInt(3)];
        String what = "seed %d, %s in vertex %d".formatted(seed, of[beyond], beyond);
        assertFalse(one.allSeen(n, x, y, z, w), what);
        assertFalse(eight.allSeen(n, x, y, z, w), what);
    }
}
