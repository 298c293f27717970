package rasterlab.engine.clip.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class ExactClipTest {
    private static final long SEED = 32;
    private static final int TRIALS = 20_000;

    /**
     * The sizes of coordinates: the least double is a few of one, or the product of two of another.
     */
    private static final double[] UNITS = {1, 1e-320, 0x1p-538, 1e100, 0.1};

    @Test
    @DisplayName("a segment that touches the window, or misses it by a last digit, is misjudged")
    void meetsWhereSomethingIsLeft() {
        var random = new Random(SEED);
        int left = 0;
        for (int i = 0; i < TRIALS; i++) {
            double unit = UNITS[i % UNITS.length];
            double[] window = numbers(random, unit);
            Arrays.sort(window);
            double[] sides = {window[0], window[1], window[2], window[3]};
            double[] ends = numbers(random, unit);
            boolean meets = ExactClip.meets(sides, ends);
            assertEquals(
                    ExactClip.plane(sides, ends).isPresent(),
                    meets,
                    () ->
                            "seed %d: %s in %s"
                                    .formatted(
                                            SEED, Arrays.toString(ends), Arrays.toString(sides)));
            if (meets) left++;
        }
        assertTrue(left > TRIALS / 10 && left < TRIALS - TRIALS / 10, left + " of " + TRIALS);
    }

    /** Four small multiples of a unit, now and then one last digit beside. */
    private static double[] numbers(Random random, double unit) {
        var numbers = new double[4];
        for (int i = 0; i < numbers.length; i++) {
            double whole = (random.nextInt(13) - 6) * unit;
            int beside = random.nextInt(6);
            numbers[i] =
                    beside == 0 ? Math.nextUp(whole) : beside == 1 ? Math.nextDown(whole) : whole;
        }
        return numbers;
    }
}
