package rasterlab.exercises.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumberTextTest {
    @ParameterizedTest(name = "{0} is written {1}")
    @CsvSource({
        "0.1, 0.1",
        "-2.5, -2.5",
        "1e5, 100000",
        "1234567, 1.23457·10⁶",
        "0.0001, 0.0001",
        "0.00001, 1·10⁻⁵",
        "-1.5e300, -1.5·10³⁰⁰",
        "4.9e-324, 4.94066·10⁻³²⁴",
        "-0.0, -0",
        "NaN, NaN",
        "-Infinity, -∞"
    })
    void writesFewDigits(double value, String written) {
        assertEquals(written, NumberText.of(value));
    }

    @ParameterizedTest(name = "in {0} {1}")
    @CsvSource({"en, −1.5·10³⁰⁰", "ru, '−1,5·10³⁰⁰'"})
    void aPictureHasTheDecimalSignOfItsLanguage(String language, String written) {
        assertEquals(written, NumberText.inPicture("-1.5·10³⁰⁰", language));
    }

    @Test
    void neighbouringNumbersLookDifferent() {
        long seed = new Random().nextLong();
        var random = new Random(seed);
        for (int i = 0; i < 2000; i++) {
            double one = Double.longBitsToDouble(random.nextLong());
            if (!Double.isFinite(one)) continue;
            double next = Math.nextUp(one);
            int digits = NumberText.telling(one, next);
            assertNotEquals(
                    NumberText.of(one, digits), NumberText.of(next, digits), "seed " + seed);
        }
    }
}
