package rasterlab.engine.pipeline.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;

class LightFalloffTest {
    private static final int STEPS = 50;

    @Test
    @DisplayName(
            "strength and light that both change linearly have no bend together, or half of it")
    void productOfTwoSlopesBendsTwice() {
        double strength = 2;
        double slope = 3;
        // f = 1 + t and c = 1 + 3t on [0, 1]: (f·c)″ = 2·f′·c′ = 6.
        assertEquals(2 * slope, new LightFalloff(strength, 1, 0).times(4, slope, 0), 1e-12);
    }

    @RepeatedTest(value = 20, name = "a product of two parabolas bends more than it may")
    void productBendsNoMoreThanItsBound(RepetitionInfo repetition) {
        var random = new Random(repetition.getCurrentRepetition());
        double[] f = parabola(random);
        double[] c = parabola(random);
        var falloff = new LightFalloff(most(f, 0), most(f, 1), most(f, 2));
        double bound = falloff.times(most(c, 0), most(c, 1), most(c, 2));
        for (int i = 0; i <= STEPS; i++) {
            double t = (double) i / STEPS;
            double second =
                    at(f, 2, t) * at(c, 0, t)
                            + 2 * at(f, 1, t) * at(c, 1, t)
                            + at(f, 0, t) * at(c, 2, t);
            assertTrue(Math.abs(second) <= bound + 1e-12, () -> second + " above " + bound);
        }
    }

    private static double[] parabola(Random random) {
        return new double[] {
            random.nextGaussian(), 2 * random.nextGaussian(), random.nextGaussian() / 4
        };
    }

    /** A derivative of a parabola. */
    private static double at(double[] parabola, int derivative, double t) {
        return switch (derivative) {
            case 0 -> parabola[0] + t * (parabola[1] + t * parabola[2]);
            case 1 -> parabola[1] + 2 * t * parabola[2];
            default -> 2 * parabola[2];
        };
    }

    private static double most(double[] parabola, int derivative) {
        double most = 0;
        for (int i = 0; i <= STEPS; i++)
            most = Math.max(most, Math.abs(at(parabola, derivative, (double) i / STEPS)));
        return most;
    }
}
