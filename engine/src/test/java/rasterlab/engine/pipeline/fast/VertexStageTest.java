package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;

/** Whether a vertex beyond a plane is noticed wherever it stands among the others. */
class VertexStageTest {
    private static final int ROOM = 64;

    private final float[] x = new float[ROOM];
    private final float[] y = new float[ROOM];
    private final float[] z = new float[ROOM];
    private final float[] w = new float[ROOM];
    private Random random;
    private int seed;
    private int n;

    @BeforeEach
    void placeVertices(RepetitionInfo repetition) {
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

    @RepeatedTest(40)
    void noticeEachVertexBeyondAPlane() {
        assertTrue(VertexStage.allSeen(n, x, y, z, w), "seed " + seed);
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
        assertFalse(VertexStage.allSeen(n, x, y, z, w), what);
    }
}
