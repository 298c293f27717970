package rasterlab.exercises.published;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShownWordsTest {
    @ParameterizedTest(name = "{0} is shown in other signs")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "pixel (-3, -40) is missing | pixel (−3, −40) is missing",
                "cell 2: -0.5, right is -∞ | cell 2: −0.5, right is −∞",
                "it threw \"index -1\" at x = -1 | it threw \"index -1\" at x = −1",
                "printed in “case -1”: x = -1 | printed in “case -1”: x = −1",
                "напечатано в «тест -1»: x = -1 | напечатано в «тест -1»: x = −1",
                "face-1 of shortest-diagonal, 3-4 | face-1 of shortest-diagonal, 3-4",
                "#+-. | #+-."
            })
    void aMinusHasItsSign(String inJson, String shown) {
        assertEquals(shown, ShownWords.of(inJson));
    }
}
