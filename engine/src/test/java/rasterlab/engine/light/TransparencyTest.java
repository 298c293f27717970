package rasterlab.engine.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class TransparencyTest {
    private static final double[] BLACK = new double[3];

    /** Red glass and blue glass, both half transparent. */
    private static final double[] RED_BLUE = {1, 0, 0, 0.5, 0, 0, 1, 0.5};

    @Test
    void chapter7MixesTheNearerIntensityByItsAlpha() {
        assertEquals(0.8 * 0.25 + 0.4 * 0.75, Transparency.over(0.8, 0.25, 0.4), 1e-15);
    }

    @Test
    void nearerGlassColoursMoreWhateverTheOrderGiven() {
        double[] redNear = {0.5, 0, 0.25};
        assertArrayEquals(redNear, Transparency.seen(new double[] {1, 2}, RED_BLUE, BLACK), 1e-15);
        double[] blueNear = {0.25, 0, 0.5};
        assertArrayEquals(blueNear, Transparency.seen(new double[] {2, 1}, RED_BLUE, BLACK), 1e-15);
    }

    @Test
    void ofEqualDepthsTheLaterIsNearer() {
        assertArrayEquals(
                new double[] {0.25, 0, 0.5},
                Transparency.seen(new double[] {1, 1}, RED_BLUE, BLACK),
                1e-15);
    }

    @Test
    void nothingInFrontLeavesTheBackground() {
        double[] background = {0.1, 0.2, 0.3};
        assertArrayEquals(background, Transparency.seen(new double[0], new double[0], background));
    }

    @Test
    void refusesADepthThatIsNoNumber() {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> Transparency.farToNear(new double[] {1, Double.NaN}));
        assertEquals("depths[1] must be a number, got NaN", refusal.getMessage());
    }
}
