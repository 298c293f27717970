package rasterlab.engine.study.measuring;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MedianIntervalTest {
    /** Ranks at 99 %, as in Le Boudec's table of appendix A, which has none below eight values. */
    @ParameterizedTest(name = "of {0} values the one of rank {1} is the lower end")
    @CsvSource({"1, 1", "5, 1", "8, 1", "11, 1", "12, 2", "15, 3", "20, 4", "36, 10", "70, 24"})
    void rankIsThatOfTheTable(int values, int rank) {
        assertEquals(rank, MedianInterval.rank(values));
    }

    /** Coins that fall often enough are normally distributed: ranks are (n − 2.576 √n) / 2. */
    @ParameterizedTest(name = "of {0} values the lower end is above the upper one, or too far away")
    @ValueSource(ints = {1000, 1074, 1075, 1076, 2000, 50_000})
    void rankOfManyIsThatOfTheNormalDistribution(int values) {
        assertEquals((values - 2.576 * Math.sqrt(values)) / 2, MedianInterval.rank(values), 1.5);
        MedianInterval.ofMedian(IntStream.range(0, values).asDoubleStream().toArray());
    }

    @Test
    void itHoldsTheTrueMedianAsOftenAsItPromises() {
        var random = new Random(7);
        int held = 0;
        for (int run = 0; run < 2000; run++) {
            double[] skewed =
                    IntStream.range(0, 11)
                            .mapToDouble(i -> Math.exp(2 * random.nextGaussian()))
                            .toArray();
            MedianInterval interval = MedianInterval.ofMedian(skewed);
            if (interval.low() <= 1 && 1 <= interval.high()) held++;
        }
        assertTrue(held >= 0.99 * 2000 - 20, held + " of 2000");
    }

    @Test
    void oneOutlierDoesNotMoveIt() {
        double[] calm = {10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10_000};
        assertEquals(new MedianInterval(10, 10, 10), MedianInterval.ofMedian(calm));
    }

    @Test
    void noValueIsNoMedian() {
        assertThrows(IllegalArgumentException.class, () -> MedianInterval.ofMedian(new double[0]));
    }
}
