package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RoundTicksTest {
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "step is too small, 0.3, 0.5",
        "step is not round, 3, 5",
        "round distance is passed over, 2, 2",
        "next power is forgotten, 7, 10",
        "small power is inexact, 0.0007, 0.001",
        "large power is inexact, 3e89, 5e89",
    })
    void stepIsTheLeastRoundNumber(String mistake, double distance, double step) {
        assertEquals(step, RoundTicks.atLeast(distance).step(), mistake);
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "rounding shows, 0.1, 3, en, 0.3",
        "decimals jump, 0.5, 2, en, 1.0",
        "zero has decimals, 0.5, 0, en, 0",
        "English comma in Russian, 0.5, 1, ru, '0,5'",
        "minus is a hyphen, 2, -3, en, −6",
        "long zeros, 5e89, 3, en, 1.5·10⁹⁰",
        "long fraction, 2e-9, 3, en, 6·10⁻⁹",
    })
    void numbersAreShort(String mistake, double distance, long tick, String locale, String shown) {
        assertEquals(
                shown,
                RoundTicks.atLeast(distance).shown(tick, Locale.forLanguageTag(locale)),
                mistake);
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "noise of doubles stays, 0.30000000000000004, 0.1, 0.3",
        "whole tens are missed, 1234, 10, 1230",
        "minus zero, -0.001, 0.1, 0",
        "large number overflows, 1e308, 1e-5, 1e308",
    })
    void roundedHasNoDigitsBelow(String mistake, double value, double least, double rounded) {
        assertEquals(rounded, RoundTicks.rounded(value, least), mistake);
    }
}
