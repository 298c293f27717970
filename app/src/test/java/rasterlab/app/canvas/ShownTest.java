package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShownTest {
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "zeros at the end, 2.5, en, 2.5",
        "too many digits, 0.123456, en, 0.1235",
        "English comma in Russian, 2.5, ru, '2,5'",
        "minus is a hyphen, -3, en, −3",
        "minus zero, -0.0, en, 0",
        "small number is 0, 0.00000012, en, 1.2·10⁻⁷",
        "long number, 3e90, en, 3·10⁹⁰",
        "not a number, NaN, en, NaN",
        "infinity, -Infinity, en, −Infinity",
    })
    void numbersAreShortAndTrue(String mistake, double value, String locale, String shown) {
        assertEquals(shown, Shown.number(value, Locale.forLanguageTag(locale)), mistake);
    }

    @Test
    void commaInsideNumbersDoesNotPartCoordinates() {
        assertEquals("(1.5, 2)", Shown.point(1.5, 2, Locale.ENGLISH));
        assertEquals("(1,5; 2)", Shown.point(1.5, 2, Locale.forLanguageTag("ru")));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "rounding beside 1 is shown, 5.55e-17, 1, 0",
        "rounding of the other sign is shown, -5.55e-17, -1, 0",
        "small number that is no rounding is hidden, 1.2e-7, 1, 1.2·10⁻⁷",
        "small number among small ones is hidden, 3e-200, 4e-200, 3·10⁻²⁰⁰",
        "number given beside a huge one is hidden, 5, 1e30, 5",
        "number beside infinity is hidden, 2, Infinity, 2",
        "infinity is hidden, Infinity, Infinity, Infinity",
    })
    void roundingBesideOthersReadsAsZero(
            String mistake, double value, double largest, String shown) {
        assertEquals(shown, Shown.coordinate(value, largest, 4, Locale.ENGLISH), mistake);
    }

    @Test
    void pointOnAnAxisHasAZero() {
        assertEquals("(1, 0)", Shown.point(1, 6.1e-17, Locale.ENGLISH));
    }
}
