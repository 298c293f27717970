package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import rasterlab.engine.color.Levels;

class PixelLevelsTest {
    private static final int COUNT = 2001;

    private final float[][] shares = new float[4][COUNT];
    private final int[] argb = new int[COUNT];

    /** Shares from a little below 0 to a little above 1, another order in each channel. */
    PixelLevelsTest() {
        for (int c = 0; c < 4; c++)
            for (int i = 0; i < COUNT; i++)
                shares[c][i] = Math.nextUp(1f) * (i * (2 * c + 1) % COUNT) / (COUNT - 1) - 1e-9f;
    }

    private int expected(int i, double alpha) {
        return Levels.argb(shares[0][i], shares[1][i], shares[2][i], alpha);
    }

    @Test
    void eachChannelIsRoundedOnItsOwn() {
        int[] expected = new int[COUNT];
        for (int i = 0; i < COUNT; i++) expected[i] = expected(i, shares[3][i]);
        PixelLevels.pack(COUNT, shares[0], shares[1], shares[2], argb);
        PixelLevels.setAlpha(COUNT, shares[3], argb);
        for (int i = 0; i < COUNT; i++) assertEquals(expected[i], argb[i], "colour " + i);
    }

    @Test
    void withoutAlphaAllIsOpaque() {
        int[] expected = new int[COUNT];
        for (int i = 0; i < COUNT; i++) expected[i] = expected(i, 1);
        PixelLevels.pack(COUNT, shares[0], shares[1], shares[2], argb);
        for (int i = 0; i < COUNT; i++) assertEquals(expected[i], argb[i], "colour " + i);
    }
}
