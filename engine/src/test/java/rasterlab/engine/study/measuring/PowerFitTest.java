package rasterlab.engine.study.measuring;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

class PowerFitTest {
    private static List<PowerFit.FittedPoint> square(double noise, long seed) {
        var random = new Random(seed);
        var points = new ArrayList<PowerFit.FittedPoint>();
        for (int n : new int[] {16, 64, 256, 1024, 4096})
            points.add(
                    new PowerFit.FittedPoint(
                            n, 3.0 * n * n * Math.exp(noise * random.nextGaussian())));
        return points;
    }

    @Test
    void aSquareIsFoundExactly() {
        PowerFit fit = PowerFit.of(square(0, 1)).orElseThrow();
        assertEquals(2, fit.exponent(), 1e-12);
        assertEquals(3, fit.factor(), 1e-9);
        assertTrue(fit.margin() < 1e-9, "" + fit);
    }

    @Test
    void theIntervalHoldsTheTruePowerAsOftenAsItPromises() {
        int held = 0;
        for (int run = 0; run < 1000; run++) {
            PowerFit fit = PowerFit.of(square(0.2, run)).orElseThrow();
            if (Math.abs(fit.exponent() - 2) <= fit.margin()) held++;
        }
        assertTrue(held > 930 && held < 970, held + " of 1000");
    }

    @Test
    void twoSizesTellNoInterval() {
        assertEquals(Optional.empty(), PowerFit.of(square(0, 1).subList(0, 2)));
    }
}
