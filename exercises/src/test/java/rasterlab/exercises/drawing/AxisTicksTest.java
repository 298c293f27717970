package rasterlab.exercises.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.exercises.drawing.AxisTicks.AxisTick;

class AxisTicksTest {
    @ParameterizedTest(name = "{0} to {1}: {2} {3}")
    @CsvSource({
        "0, 10, 0 5 10, ''",
        "-3, 3, −2 0 2, ''",
        "0, 1, 0 0.5 1.0, ''",
        "0, 3, 0 1 2 3, ''",
        "0.999, 1.0004, 0.9990 0.9995 1.0000, ''",
        "0, 40000, 0 20000 40000, ''",
        "0, 3e300, 0 1 2 3, ·10³⁰⁰",
        "0, 2.9e-9, 0 1 2, ·10⁻⁹",
        "-1e308, 1e308, −1 0 1, ·10³⁰⁸",
        "1e9, 1000000010, 0 5 10, + 1·10⁹",
        "-1000000010, -1e9, −10 −5 0, − 1·10⁹"
    })
    void labelsAreShort(double low, double high, String labels, String note) {
        AxisTicks ticks = AxisTicks.of(new AxisRange(low, high), 3);
        assertEquals(
                labels,
                ticks.ticks().stream().map(AxisTick::label).collect(Collectors.joining(" ")));
        assertEquals(note, ticks.note());
    }

    @Test
    void anyRangeHasAFewShortTicksInsideIt() {
        long seed = new Random().nextLong();
        var random = new Random(seed);
        for (int i = 0; i < 2000; i++) {
            double[] n = new AnyNumbers(random).some(2);
            if (!Double.isFinite(n[0]) || !Double.isFinite(n[1]) || n[0] == n[1]) continue;
            var range = new AxisRange(Math.min(n[0], n[1]), Math.max(n[0], n[1]));
            String message = "seed " + seed + ": " + range;
            AxisTicks ticks = AxisTicks.of(range, 4);
            assertTrue(ticks.ticks().size() <= 5, message);
            for (AxisTick tick : ticks.ticks()) {
                assertTrue(range.contains(tick.value()), message);
                String digits = tick.label().replaceAll("[−.]", "").replaceAll("^0+", "");
                assertTrue(digits.length() <= 5, message + " " + tick.label());
            }
        }
    }
}
